// SPDX-License-Identifier: MIT
#include "odas/separation/mask_filter.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "odas/base/contract.hpp"
#include "odas/dsp/tiny_power.hpp"

namespace odas {
namespace {

// Time constants, s: of the leakage, of a voice's power that falls, and of the decision-directed SNR.
constexpr float kLeakSeconds = 0.4F;
constexpr float kFallSeconds = 0.016F;
constexpr float kTrustSeconds = 0.1F;

float step(float hop_seconds, float seconds) noexcept { return 1 - std::exp(-hop_seconds / seconds); }

}  // namespace

float log_spectral_gain(float v) noexcept {
  return std::sqrt(1 + 0.561F / (v * (1 + v * (0.9F + v * (0.2F + v * 0.185F)))));
}

MaskFilter::MaskFilter(const MaskFilterConfig& config, const GeneralConfig& general, std::size_t slots)
    : config_(config),
      leak_step_(step(hop_seconds_of(general), kLeakSeconds)),
      fall_(step(hop_seconds_of(general), kFallSeconds)),
      trust_(1 - step(hop_seconds_of(general), kTrustSeconds)),
      ids_(slots),
      room_(static_cast<std::size_t>(general.size.frame_size) / 2 + 1, hop_seconds_of(general)),
      noise_(slots, room_),
      power_(slots, room_.power().size()),
      mask_(power_),
      voice_(power_),
      alone_(power_),
      leaked_(slots * slots, power_.cols()),
      clean_(power_),
      gains_(power_),
      disturbing_(power_.cols()) {}

void MaskFilter::apply(GridView<const cfloat> spectra, GridView<const float> /*noise_psd*/,
                       std::span<const Track> tracks, const Beamformer& beamformer,
                       GridView<const cfloat> beams, GridView<cfloat> filtered) noexcept {
  ODAS_EXPECT(tracks.size() == ids_.size() && beams.rows() == ids_.size() && filtered.rows() == ids_.size());
  ODAS_EXPECT(beams.cols() == power_.cols() && filtered.cols() == power_.cols());
  follow(tracks);
  measure(spectra, beams);
  find_voices(beamformer);
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    const std::span<cfloat> out = filtered[s];
    if (ids_[s] == 0) {
      std::fill(out.begin(), out.end(), cfloat{});
      continue;
    }
    std::ranges::copy(noise_[s].power(), disturbing_.begin());
    add_leakage(s);
    shape(s);
    const std::span<const float> gain = gains_[s];
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = std::isfinite(std::norm(beams[s][k])) ? gain[k] * beams[s][k] : cfloat{};
    }
  }
}

/// What all voices share goes with the last of them, as in AdaptiveBeamformer.
void MaskFilter::follow(std::span<const Track> tracks) noexcept {
  bool anybody = false, stays = false;
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    anybody = anybody || ids_[s] != 0;
    stays = stays || (ids_[s] != 0 && ids_[s] == tracks[s].id);
  }
  if (anybody && !stays) room_.reset();
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    if (ids_[s] == tracks[s].id) continue;
    ids_[s] = tracks[s].id;
    if (ids_[s] != 0) begin(s);
  }
}

void MaskFilter::begin(std::size_t slot) noexcept {
  noise_[slot].take_over(room_);
  std::ranges::fill(voice_[slot], 0.F);
  std::ranges::fill(alone_[slot], kTinyPower);
  std::ranges::fill(clean_[slot], 0.F);
  for (std::size_t other = 0; other < ids_.size(); ++other) {
    const std::span<float> in = leaked_[slot * ids_.size() + other],
                           out = leaked_[other * ids_.size() + slot];
    for (std::size_t k = 0; k < in.size(); ++k) {
      in[k] = config_.leak * alone_[other][k];
      out[k] = config_.leak * alone_[slot][k];
    }
  }
}

void MaskFilter::measure(GridView<const cfloat> spectra, GridView<const cfloat> beams) noexcept {
  const auto powers = [](std::span<const cfloat> of, std::span<const float> noise, std::span<float> power) {
    for (std::size_t k = 0; k < of.size(); ++k) {
      const float p = std::norm(of[k]);
      power[k] = std::isfinite(p) ? p : noise[k];
    }
  };
  powers(spectra[0], room_.power(), disturbing_);
  room_.update(disturbing_);
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    if (ids_[s] == 0) continue;
    powers(beams[s], noise_[s].power(), power_[s]);
    noise_[s].update(power_[s]);
  }
}

void MaskFilter::find_voices(const Beamformer& beamformer) noexcept {
  std::ranges::fill(disturbing_, kTinyPower);  // for now: of all beams
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    if (ids_[s] == 0) continue;
    for (std::size_t k = 0; k < disturbing_.size(); ++k) disturbing_[k] += power_[s][k];
  }
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    if (ids_[s] == 0) continue;
    const std::span<const float> known = beamformer.mask(s);
    const std::span<const float> power = power_[s];
    const std::span<float> mask = mask_[s], voice = voice_[s], alone = alone_[s];
    for (std::size_t k = 0; k < mask.size(); ++k) {
      mask[k] = known.empty() ? power[k] / disturbing_[k] : std::min(known[k], 1.F);
    }
    for (std::size_t k = 0; k < mask.size(); ++k) {
      const float now = mask[k] * power[k];
      voice[k] = std::max(now, voice[k] + fall_ * (now - voice[k]));
      alone[k] += leak_step_ * (mask[k] * mask[k] * now - alone[k]);
    }
  }
}

void MaskFilter::add_leakage(std::size_t slot) noexcept {
  const std::span<const float> power = power_[slot], noise = noise_[slot].power();
  for (std::size_t other = 0; other < ids_.size(); ++other) {
    if (other == slot || ids_[other] == 0) continue;
    const std::span<const float> mask = mask_[other], voice = voice_[other], alone = alone_[other];
    const std::span<float> leaked = leaked_[slot * ids_.size() + other];
    for (std::size_t k = 0; k < leaked.size(); ++k) {
      const float heard = mask[k] * mask[k] * std::max(power[k] - noise[k], 0.F);
      leaked[k] += leak_step_ * (heard - leaked[k]);
      disturbing_[k] += std::min(leaked[k] / (alone[k] + kTinyPower), 1.F) * voice[k];
    }
  }
}

void MaskFilter::shape(std::size_t slot) noexcept {
  const std::span<const float> power = power_[slot];
  const std::span<float> clean = clean_[slot], gain = gains_[slot];
  for (std::size_t k = 0; k < gain.size(); ++k) {
    const float one = 1 / (disturbing_[k] + kTinyPower);
    const float gamma = power[k] * one;
    const float xi = trust_ * clean[k] * one + (1 - trust_) * std::max(gamma - 1, 0.F);
    const float wiener = xi / (1 + xi);
    const float g = wiener * log_spectral_gain(std::clamp(wiener * gamma, 1e-3F, 1e3F));
    gain[k] = std::clamp(g, config_.g_min, 1.F);
    clean[k] = gain[k] * gain[k] * power[k];
  }
}

void MaskFilter::reset() noexcept {
  std::fill(ids_.begin(), ids_.end(), 0);
  room_.reset();
  for (PresenceNoise& noise : noise_) noise.reset();
  for (Grid<float>* grid : {&power_, &mask_, &voice_, &alone_, &leaked_, &clean_, &gains_}) grid->fill(0);
}

}  // namespace odas
