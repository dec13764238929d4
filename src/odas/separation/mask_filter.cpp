// SPDX-License-Identifier: MIT
#include "odas/separation/mask_filter.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "odas/base/contract.hpp"
#include "odas/dsp/tiny_power.hpp"

namespace odas {
namespace {
// Weights of the new value per hop: in the powers of beams, and in a gain that falls.
constexpr float kFollow = 0.5F;
constexpr float kFall = 0.5F;

}  // namespace

MaskFilter::MaskFilter(const MaskFilterConfig& config, const GeneralConfig& general, std::size_t slots)
    : config_(config),
      ids_(slots),
      power_(slots, static_cast<std::size_t>(general.size.frame_size) / 2 + 1),
      gains_(slots, power_.cols()),
      sum_(power_.cols()),
      raw_(power_.cols()) {}

void MaskFilter::apply(GridView<const cfloat> /*spectra*/, GridView<const float> /*noise_psd*/,
                       std::span<const Track> tracks, const Beamformer& beamformer,
                       GridView<const cfloat> beams, GridView<cfloat> filtered) noexcept {
  ODAS_EXPECT(tracks.size() == ids_.size() && beams.rows() == ids_.size() && filtered.rows() == ids_.size());
  ODAS_EXPECT(beams.cols() == sum_.size() && filtered.cols() == sum_.size());
  measure(tracks, beams);
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    const std::span<cfloat> out = filtered[s];
    if (tracks[s].id == 0) {
      std::fill(out.begin(), out.end(), cfloat{});
      continue;
    }
    shape(s, beamformer.mask(s));
    const std::span<const float> gain = gains_[s];
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = std::isfinite(std::norm(beams[s][k])) ? gain[k] * beams[s][k] : cfloat{};
    }
  }
}

void MaskFilter::measure(std::span<const Track> tracks, GridView<const cfloat> beams) noexcept {
  std::fill(sum_.begin(), sum_.end(), kTinyPower);
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    if (tracks[s].id == 0) {
      ids_[s] = 0;
      continue;
    }
    const std::span<float> power = power_[s];
    if (ids_[s] != tracks[s].id) {
      ids_[s] = tracks[s].id;
      std::fill(power.begin(), power.end(), 0.F);
      std::fill(gains_[s].begin(), gains_[s].end(), 1.F);
    }
    for (std::size_t k = 0; k < raw_.size(); ++k) {
      const float p = std::norm(beams[s][k]);
      raw_[k] = std::isfinite(p) ? p : power[k];
    }
    for (std::size_t k = 0; k < raw_.size(); ++k) {
      const float near =
          0.25F * raw_[k == 0 ? 0 : k - 1] + 0.5F * raw_[k] + 0.25F * raw_[k + 1 == raw_.size() ? k : k + 1];
      power[k] += kFollow * (near - power[k]);
      sum_[k] += power[k];
    }
  }
}

void MaskFilter::shape(std::size_t slot, std::span<const float> mask) noexcept {
  const std::span<const float> power = power_[slot];
  for (std::size_t k = 0; k < raw_.size(); ++k) {
    const float m = mask.empty() ? power[k] / sum_[k] : std::min(mask[k], 1.F);
    raw_[k] = std::max(m / (m + config_.leak * (1 - m) + kTinyPower), config_.g_min);
  }
  const std::span<float> gain = gains_[slot];
  for (std::size_t k = 0; k < raw_.size(); ++k) {
    const float near =
        0.25F * raw_[k == 0 ? 0 : k - 1] + 0.5F * raw_[k] + 0.25F * raw_[k + 1 == raw_.size() ? k : k + 1];
    gain[k] += (near < gain[k] ? kFall : 1.F) * (near - gain[k]);
  }
}

void MaskFilter::reset() noexcept {
  std::fill(ids_.begin(), ids_.end(), 0);
  power_.fill(0);
  gains_.fill(0);
}

}  // namespace odas
