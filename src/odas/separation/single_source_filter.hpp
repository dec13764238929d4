// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/separation/config.hpp"
#include "odas/separation/post_filter.hpp"

namespace odas {

/// Single-source post-filter (`ss`): lets a bin pass as far as the microphones agree on it.
///
/// Method: r = |y|^2 / (n sum |W_m x_m|^2 + eps), in 0..1 by Cauchy and Schwarz: 1 where all weighted
///   microphones are in phase, 1/n for noise. G = Gmin + (1 - Gmin) / (1 + exp(-Gslope (r - Gmid))).
/// Symbols: n: microphones that hear the direction; W: demixing weights.
/// Source: ODAS 9.6. Departs: ODAS counts all microphones in n, also those that do not hear the direction,
///   so that r never comes near 1 on a closed array.
/// Shapes: see PostFilter. Delay: none. Memory: none between hops.
/// Cost per hop: slots x mics x bins products, and one exponential a bin and slot.
/// Fails: diffuse noise at low frequencies is in phase everywhere and passes.
class SingleSourceFilter final : public PostFilter {
 public:
  SingleSourceFilter(const SingleSourceFilterConfig& config, const GeneralConfig& general);

  void apply(GridView<const cfloat> spectra, GridView<const float> noise_psd, std::span<const Track> tracks,
             const Beamformer& beamformer, GridView<const cfloat> beams,
             GridView<cfloat> filtered) noexcept override;
  [[nodiscard]] bool needs_noise() const noexcept override { return false; }
  void reset() noexcept override {}

 private:
  SingleSourceFilterConfig config_;
  float epsilon_;
  std::vector<float> parts_;  // [bin]: sum |W_m x_m|^2
};

}  // namespace odas
