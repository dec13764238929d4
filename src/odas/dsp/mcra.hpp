// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/dsp/mcra_config.hpp"
#include "odas/dsp/noise_estimator.hpp"

namespace odas {

/// Noise power of several channels, followed through the pauses of speech (MCRA).
///
/// Method, per channel and hop, P = |X|^2:
///   Sf = h * P over frequency (h: Hann of b points without its zero ends, sum 1; mirrored at both ends),
///   S <- (1 - alphaS) S + alphaS Sf,  Smin: minimum of S over the last L to 2 L hops,
///   where S < delta Smin (no speech), or where the estimate exceeds S: psd <- (1 - alphaD) psd + alphaD P.
/// Source: Cohen and Berdugo, "Noise estimation by minima controlled recursive averaging for robust speech
///   enhancement", 2002; parameters as ODAS 6. Departs from ODAS: h is the intended window (fault B1 there),
///   and the estimate starts with the first sound: the first 1 / alphaS hops count as noise, all in equal
///   parts (ODAS's minimum starts at zero, and its estimate stays zero for 2 L + 3 hops).
/// Shapes: [channel][bin]; powers as the DFT gives them.
/// Errors: a hop that is not finite, or silent before the first sound, is passed over for that channel.
/// Fails: noise that rises by more than delta is taken for speech for L to 2 L hops.
class Mcra final : public NoiseEstimator {
 public:
  Mcra(const McraConfig& config, std::size_t channels, std::size_t bins);

  /// spectra [channel][bin]
  void update(GridView<const cfloat> spectra) noexcept;
  void update(std::size_t channel, std::span<const float> power) noexcept override;
  [[nodiscard]] GridView<const float> psd() const noexcept override { return psd_; }
  void reset(std::size_t channel, std::span<const float> known) noexcept override;
  void reset(std::size_t channel) noexcept override;
  void reset() noexcept;

 private:
  void smooth(std::span<const float> power) noexcept;

  float alpha_s_, delta_, alpha_d_;
  int period_;                         // hops after which the minimum forgets
  int warm_up_;                        // hops that count as noise
  std::vector<float> window_;          // h
  std::vector<std::size_t> mirrored_;  // [bin + b - 1]: the bin that stands there
  std::vector<float> extended_;        // [bin + b - 1]: P, mirrored at both ends
  std::vector<float> over_bins_;       // Sf
  std::vector<float> power_;           // P
  std::vector<int> heard_;             // [channel]: hops since the start, as far as they matter
  std::vector<int> age_;               // [channel]: hops of the running minimum
  Grid<float> smoothed_, minimum_, next_minimum_, psd_;
};

}  // namespace odas
