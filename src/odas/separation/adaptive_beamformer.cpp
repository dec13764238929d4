// SPDX-License-Identifier: MIT
#include "odas/separation/adaptive_beamformer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "odas/base/contract.hpp"
#include "odas/dsp/noise_field.hpp"
#include "odas/dsp/tiny_power.hpp"
#include "odas/separation/factor_kernels.hpp"

namespace odas {
namespace {

// What is learned while somebody walks is forgotten within this time, s.
constexpr float kWalkingMemory = 0.4F;
// A new voice begins as if it had been seen along its direction for this share of a memory.
constexpr float kPrior = 0.02F;
// and as if it spoke half of the time: a voice that begins must not begin in the dark.
constexpr float kBirthShare = 0.5F;
// The Wiener share turns down by 14 dB at most.
constexpr float kMostWiener = 4;
// Of the level as it is when a voice begins, what is not the known noise counts so much: most of it is the
// voice itself.
constexpr float kUnknown = 0.1F;
// Cosine of the angle from which on a talker has moved: 1 degree.
constexpr float kStill = 0.99985F;
// Weights of the new value per hop: in the powers of the beams, and in levels of about a second.
constexpr float kQuick = 0.5F;
constexpr float kSlow = 0.02F;
// The noise floor is the least of the power smoothed so; it may rise by 2 dB a second.
constexpr float kFloorStep = 0.1F;
constexpr float kFloorRise = 1.004F;
// The least of a smoothed power lies under its mean by about this factor.
constexpr float kFloorBias = 2;
// Loading grows and shrinks by this each time, and no further than that.
constexpr float kLoadStep = 1.1F;
constexpr float kMostLoading = 1e3F;
// The power that silence counts as, with samples of full scale 1: under one 24-bit step in a frame.
constexpr float kSilence = 1e-12F;

/// to = scale from, bin by bin, all rows.
void scale(const BinBlocks& from, const BinReals& by, BinBlocks& to) noexcept {
  for (std::size_t b = 0; b < from.blocks(); ++b) {
    const float* s = by.data() + b * kBlockBins;
    for (std::size_t r = 0; r < from.rows(); ++r) {
      const float* p = from.at(b, r);
      float* q = to.at(b, r);
      for (std::size_t i = 0; i < kBlockBins; ++i) {
        q[i] = s[i] * p[i];
        q[i + kBlockBins] = s[i] * p[i + kBlockBins];
      }
    }
  }
}

/// power = |row 0|^2 of each bin.
void square(const BinBlocks& row, BinReals& power) noexcept {
  for (std::size_t b = 0; b < row.blocks(); ++b) {
    const float* p = row.at(b, 0);
    float* out = power.data() + b * kBlockBins;
    for (std::size_t i = 0; i < kBlockBins; ++i) {
      out[i] = p[i] * p[i] + p[i + kBlockBins] * p[i + kBlockBins];
    }
  }
}

float decibels(float ratio) noexcept { return 10 * std::log10(std::max(ratio, kTinyPower)); }

}  // namespace

AdaptiveBeamformer::AdaptiveBeamformer(Criterion criterion, const AdaptiveConfig& config,
                                       const GeneralConfig& general, std::size_t slots)
    : criterion_(criterion),
      config_(config),
      mics_(general.mics.size()),
      bins_(static_cast<std::size_t>(general.size.frame_size) / 2 + 1),
      every_(4 * general.size.hop_size <= general.size.frame_size ? 2 : 1),
      seconds_(static_cast<float>(every_) * hop_seconds_of(general)),
      share_step_(step_of(config.memory)),
      least_(std::pow(10.F, config.white_noise_gain / 10)),
      steering_(general),
      masks_(general, slots),
      stillness_(general, slots),
      slots_(slots),
      powers_(slots, BinReals(bins_)),
      x_(mics_, bins_),
      v_(mics_, bins_),
      row_(1, bins_),
      old_(mics_, bins_),
      finite_(bins_),
      power_(bins_),
      background_(bins_),
      smooth_(bins_),
      floor_(bins_),
      keep_(bins_),
      gain_(bins_),
      norm_(bins_),
      gains_(mics_),
      ray_(bins_) {
  for (Slot& slot : slots_) {
    slot.steering = slot.column = slot.solved = x_;
    slot.factor = masks_.diffuse_factor();
    slot.response = slot.talker = slot.level = slot.share = slot.loading = slot.wng = slot.gain = slot.pass =
        power_;
    slot.weights = Grid<cfloat>(mics_, bins_);
  }
}

void AdaptiveBeamformer::separate(GridView<const cfloat> spectra, std::span<const Track> tracks,
                                  GridView<cfloat> beams) noexcept {
  ODAS_EXPECT(spectra.rows() == mics_ && spectra.cols() == bins_);
  ODAS_EXPECT(tracks.size() == slots_.size() && beams.rows() == slots_.size() && beams.cols() == bins_);
  bool anybody = false;
  bool stays = false;
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    anybody = anybody || slots_[s].id != 0;
    stays = stays || (slots_[s].id != 0 && slots_[s].id == tracks[s].id);
  }
  if (anybody && !stays) forget_room();
  stillness_.update(tracks);
  step_ = step_of(memory());
  hear(spectra);
  for (std::size_t s = 0; s < slots_.size(); ++s) follow(s, tracks[s]);
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    if (slots_[s].heard) look_ahead(s);
  }
  masks_.update(x_, powers_, floor_);
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    if (slots_[s].heard && (hop_ + s) % every_ == 0) learn(s);
  }
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    form(s, beams[s]);
    if (slots_[s].heard) measure(s, beams[s]);
  }
  ++hop_;
}

/// What was learned before somebody walked is of another room.
float AdaptiveBeamformer::memory() const noexcept {
  return std::clamp(stillness_.seconds(), std::min(kWalkingMemory, config_.memory), config_.memory);
}

/// Weight of the new value.
float AdaptiveBeamformer::step_of(float memory) const noexcept { return 1 - std::exp(-seconds_ / memory); }

void AdaptiveBeamformer::hear(GridView<const cfloat> spectra) noexcept {
  power_.fill(0);
  for (std::size_t m = 0; m < mics_; ++m) {
    const cfloat* x = spectra[m].data();
    for (std::size_t k = 0; k < bins_; ++k) power_[k] += std::norm(x[k]);
  }
  for (std::size_t k = 0; k < bins_; ++k) {
    finite_[k] = std::isfinite(power_[k]) ? 1.F : 0.F;
    if (finite_[k] == 0) {
      power_[k] = 0;
      continue;
    }
    power_[k] /= static_cast<float>(mics_);
    background_[k] += (background_[k] > 0 ? kSlow : 1.F) * (power_[k] - background_[k]);
    smooth_[k] += (smooth_[k] > 0 ? kFloorStep : 1.F) * (power_[k] - smooth_[k]);
    floor_[k] = floor_[k] > 0 ? std::min(smooth_[k], floor_[k] * kFloorRise) : smooth_[k];
  }
  for (std::size_t m = 0; m < mics_; ++m) x_.set_row(m, spectra[m]);
  for (std::size_t k = 0; k < bins_; ++k) {
    if (finite_[k] > 0) continue;
    for (std::size_t m = 0; m < mics_; ++m) x_.set(m, k, {});
  }
}

void AdaptiveBeamformer::follow(std::size_t s, const Track& track) noexcept {
  Slot& slot = slots_[s];
  const bool fresh = slot.id != track.id;
  if (fresh) {
    masks_.leave(s);
    slot.heard = false;
  }
  slot.id = track.id;
  if (track.id == 0) return;
  const bool was_heard = slot.heard;
  if (was_heard && dot(slot.direction, track.direction) > kStill) return;
  const std::size_t reference = slot.reference;
  std::swap(old_, slot.steering);
  steer(slot, track.direction);
  if (!slot.heard) {
    masks_.leave(s);
    return;
  }
  masks_.listen(s, slot.steering);
  if (was_heard) {
    turn(slot, reference);
  } else {
    begin(slot);
    powers_[s] = power_;
  }
}

void AdaptiveBeamformer::steer(Slot& slot, Vec3 direction) noexcept {
  slot.direction = direction;
  steering_.gains(direction, gains_);
  const auto best = std::max_element(gains_.begin(), gains_.end());
  slot.heard = *best > 0;
  if (!slot.heard) return;
  slot.reference = static_cast<std::size_t>(best - gains_.begin());
  for (std::size_t m = 0; m < mics_; ++m) {
    steering_.row(m, direction, gains_[m], ray_);
    slot.steering.set_row(m, ray_);
  }
}

/// What was measured turns with the direction: c_m conj(old d_m) d_m, and takes the new reference.
void AdaptiveBeamformer::turn(Slot& slot, std::size_t reference) noexcept {
  for (std::size_t k = 0; k < bins_; ++k) {
    const float power = std::max(slot.column.get(reference, k).real(), kTinyPower);
    const cfloat to_new = std::conj(slot.column.get(slot.reference, k)) / power;
    const auto turned = [&](std::size_t m) {
      const cfloat by = slot.steering.get(m, k) * std::conj(old_.get(m, k));
      const float size = std::abs(by);
      return size > 0 ? slot.column.get(m, k) * to_new * (by / size) : slot.column.get(m, k) * to_new;
    };
    const cfloat zero = turned(slot.reference);
    const float size = std::abs(zero);
    const cfloat back = size > 0 ? std::conj(zero) / size : cfloat{1, 0};
    for (std::size_t m = 0; m < mics_; ++m) v_.set(m, k, turned(m) * back);
  }
  std::swap(slot.column, v_);
}

void AdaptiveBeamformer::begin(Slot& slot) noexcept {
  for (std::size_t k = 0; k < slot.level.padded().size(); ++k) {
    slot.level.data()[k] = std::max(background_.data()[k], kSilence);
    slot.share.data()[k] = kBirthShare;
    slot.loading.data()[k] = 1;
  }
  if (known_ != nullptr) {
    begin_with_noise(slot);
  } else {
    for (std::size_t k = 0; k < norm_.padded().size(); ++k) {
      norm_.data()[k] = std::sqrt(slot.level.data()[k]);
    }
    scale(masks_.diffuse_factor(), norm_, slot.factor);
  }
  for (std::size_t k = 0; k < bins_; ++k) {
    const cfloat reference = std::conj(slot.steering.get(slot.reference, k));
    for (std::size_t m = 0; m < mics_; ++m) {
      slot.column.set(m, k, kPrior * slot.level[k] * slot.steering.get(m, k) * reference);
    }
  }
  slot.signal = slot.noise = 0;
  solve(slot);
}

/// In place of diffuse sound of the whole level: the noise, and a little of all else.
void AdaptiveBeamformer::begin_with_noise(Slot& slot) noexcept {
  norm_.fill(1);  // the padding, too
  for (std::size_t k = 0; k < bins_; ++k) {
    float noise = 0;
    for (std::size_t m = 0; m < mics_; ++m) {
      noise += known_->scm(k)[m][m].real() / static_cast<float>(mics_);
    }
    slot.level[k] = noise + kUnknown * std::max(slot.level[k] - noise, 0.F);
    norm_[k] = std::sqrt(std::max(slot.level[k] - noise, kSilence));
  }
  scale(masks_.diffuse_factor(), norm_, slot.factor);
  norm_.fill(1);
  for (std::size_t j = 0; j < mics_; ++j) {
    for (std::size_t m = 0; m < mics_; ++m) v_.set_row(m, known_->column(j)[m]);
    factor_update(slot.factor, norm_, v_);
  }
}

/// What the last weights make of this hop, with unit gain.
void AdaptiveBeamformer::look_ahead(std::size_t s) noexcept {
  Slot& slot = slots_[s];
  inner_product(slot.solved, x_, row_);
  square(row_, gain_);
  for (std::size_t k = 0; k < bins_; ++k) gain_[k] /= slot.response[k] * slot.response[k] + kTinyPower;
  for (std::size_t k = 0; k < bins_; ++k) {
    const float near =
        0.25F * gain_[k == 0 ? 0 : k - 1] + 0.5F * gain_[k] + 0.25F * gain_[k + 1 == bins_ ? k : k + 1];
    powers_[s][k] += kQuick * (near - powers_[s][k]);
  }
}

void AdaptiveBeamformer::learn(std::size_t s) noexcept {
  Slot& slot = slots_[s];
  const BinReals& mask = masks_.mask(s);
  for (std::size_t k = 0; k < bins_; ++k) {
    const float g = std::min(mask[k], 1.F) * finite_[k];
    const float other = step_ * (finite_[k] - g);
    slot.share[k] += share_step_ * finite_[k] * (g - slot.share[k]);
    slot.level[k] += other * (power_[k] - slot.level[k]);
    gain_[k] = step_ * g;
    keep_[k] = 1 - other;
    norm_[k] = std::sqrt(other);
  }
  column_update(slot.column, gain_, x_, slot.reference);
  scale(x_, norm_, v_);
  factor_update(slot.factor, keep_, v_);
  if (known_ != nullptr) add_known_noise(slot);
  load(slot);
  solve(slot);
}

/// One column each time, in turn.
void AdaptiveBeamformer::add_known_noise(Slot& slot) noexcept {
  const GridView<const cfloat> column = known_->column(hop_ / every_ % mics_);
  for (std::size_t k = 0; k < bins_; ++k) gain_[k] = std::sqrt(static_cast<float>(mics_) * (1 - keep_[k]));
  for (std::size_t m = 0; m < mics_; ++m) {
    for (std::size_t k = 0; k < bins_; ++k) v_.set(m, k, gain_[k] * column[m][k]);
  }
  gain_.fill(1);
  factor_update(slot.factor, gain_, v_);
}

/// One microphone each time, in turn: the diagonal as a whole would cost as much as all the rest.
void AdaptiveBeamformer::load(Slot& slot) noexcept {
  const auto mics = static_cast<float>(mics_);
  for (std::size_t k = 0; k < bins_; ++k) {
    const float more = slot.wng[k] < least_ ? kLoadStep : 1 / kLoadStep;
    slot.loading[k] = std::clamp(slot.loading[k] * more, 1.F, kMostLoading);
    const float power =
        config_.loading * slot.loading[k] * slot.level[k] + config_.unexplained * slot.talker[k];
    norm_[k] = std::sqrt(mics * (1 - keep_[k]) * power + kSilence * kSilence);
  }
  factor_load(slot.factor, norm_, hop_ / every_ % mics_, v_);
}

void AdaptiveBeamformer::solve(Slot& slot) noexcept {
  slot.solved = slot.column;
  factor_forward(slot.factor, slot.solved, norm_);
  factor_backward(slot.factor, slot.solved);
  inner_product(slot.solved, slot.solved, row_);
  for (std::size_t k = 0; k < bins_; ++k) {
    slot.talker[k] = std::max(slot.column.get(slot.reference, k).real(), kTinyPower);
    slot.response[k] = norm_[k] / slot.talker[k];
    slot.wng[k] = slot.response[k] * slot.response[k] / (row_.get(0, k).real() + kTinyPower);
  }
}

/// That which n is multiplied by.
float AdaptiveBeamformer::gain_of(const Slot& slot, std::size_t bin) const noexcept {
  const float share = slot.share[bin];
  const float mu = config_.tradeoff * (1.01F - share) / (share + 0.01F);
  return 1 / (slot.response[bin] + std::min(mu, kMostWiener * slot.response[bin]) + kTinyPower);
}

void AdaptiveBeamformer::form(std::size_t s, std::span<cfloat> beam) noexcept {
  Slot& slot = slots_[s];
  if (!slot.heard) {
    std::fill(beam.begin(), beam.end(), cfloat{});
    return;
  }
  for (std::size_t k = 0; k < bins_; ++k) keep_[k] = kFloorBias * floor_[k] + kTinyPower;
  for (const Slot& other : slots_) {
    if (&other == &slot || !other.heard) continue;
    for (std::size_t k = 0; k < bins_; ++k) keep_[k] += other.talker[k];
  }
  if (criterion_ == Criterion::gev) {
    inner_product(slot.column, slot.column, row_);
    const auto mics = static_cast<float>(mics_);
    for (std::size_t k = 0; k < bins_; ++k) {
      gain_[k] = std::sqrt(row_.get(0, k).real() / mics) / (slot.response[k] * slot.talker[k] + kTinyPower);
    }
  } else {
    for (std::size_t k = 0; k < bins_; ++k) gain_[k] = gain_of(slot, k);
  }
  inner_product(slot.solved, x_, row_);
  for (std::size_t k = 0; k < bins_; ++k) {
    const float rho = slot.talker[k] / keep_[k];
    const float beta = rho / (rho + config_.harm);
    slot.gain[k] = gain_[k] * (1 - beta);
    slot.pass[k] = beta;
    beam[k] = slot.gain[k] * row_.get(0, k) + beta * x_.get(slot.reference, k);
  }
}

void AdaptiveBeamformer::measure(std::size_t s, std::span<const cfloat> beam) noexcept {
  Slot& slot = slots_[s];
  float signal = 0;
  float noise = 0;
  for (std::size_t k = 0; k < bins_; ++k) {
    const float power = std::norm(beam[k]);
    const float mask = masks_.mask(s)[k];
    signal += mask * power;
    noise += (1 - mask) * power;
  }
  slot.signal += kSlow * (signal - slot.signal);
  slot.noise += kSlow * (noise - slot.noise);
}

BeamReport AdaptiveBeamformer::report(std::size_t slot) const noexcept {
  const Slot& s = slots_[slot];
  if (!s.heard) return Beamformer::report(slot);
  float gain = 0;
  float condition = 0;
  for (std::size_t k = 0; k < bins_; ++k) {
    float least = s.factor.get(0, k).real();
    float most = least;
    for (std::size_t m = 1; m < mics_; ++m) {
      const float diagonal = s.factor.get(factor_row(mics_, m, m), k).real();
      least = std::min(least, diagonal);
      most = std::max(most, diagonal);
    }
    condition += 2 * decibels(most / least);
    gain += decibels(s.wng[k]);
  }
  const auto bins = static_cast<float>(bins_);
  return {decibels(s.signal / (s.noise + kTinyPower)), gain / bins, condition / bins};
}

GridView<const cfloat> AdaptiveBeamformer::weights(std::size_t slot) const noexcept {
  const Slot& s = slots_[slot];
  if (!s.heard) {
    s.weights.fill({});
    return s.weights;
  }
  for (std::size_t m = 0; m < mics_; ++m) {
    const std::span<cfloat> w = s.weights[m];
    for (std::size_t k = 0; k < bins_; ++k) w[k] = s.gain[k] * std::conj(s.solved.get(m, k));
  }
  for (std::size_t k = 0; k < bins_; ++k) s.weights[s.reference][k] += s.pass[k];
  return s.weights;
}

/// What all slots share goes with the last voice: whoever comes next begins as new.
void AdaptiveBeamformer::forget_room() noexcept {
  hop_ = 0;
  masks_.reset();
  stillness_.reset();
  background_.fill(0);
  smooth_.fill(0);
  floor_.fill(0);
}

void AdaptiveBeamformer::reset() noexcept {
  forget_room();
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    slots_[s].id = 0;
    slots_[s].heard = false;
    powers_[s].fill(0);
  }
}

}  // namespace odas
