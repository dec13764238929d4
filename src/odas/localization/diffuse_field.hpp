// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/localization/kernels.hpp"

namespace odas {

/// What noise and late echoes from everywhere leave in the correlations of open microphones: it draws peaks
/// towards lag 0, which small flat arrays take for a higher elevation.
///
/// Method: two microphones d apart hear a diffuse field with coherence sin(kd) / (kd), k = 2 pi f / c.
/// Subtracted from each correlation: IDFT(s(f) sinc(2 f d / c)), s the diffuse share of the weights. Source:
/// Cook et al., 1955; coherence subtraction as in CDR estimators (Schwarz and Kellermann, 2015). Pairs of one
/// distance (to 1 mm) share a pattern. Where a microphone is directional nothing is subtracted. Cost per hop:
/// distances x such bins x lags / 2 + pairs x lags.
class DiffuseField {
 public:
  DiffuseField(const GeneralConfig& general, std::span<const Pair> pairs, const LagTable& table,
               float bin_hz);

  /// share [bin], 0 but at `bins`; correlations [pair][column].
  void subtract(std::span<const float> share, const LagTable& table, std::span<const std::uint16_t> bins,
                std::span<float> scratch, GridView<float> correlations) noexcept;

 private:
  std::vector<std::size_t> class_;  // [pair]: its row of patterns_
  std::vector<Pair> products_;  // [distance]: channel 0, the share, times channel 1 + distance, its coherence
  Grid<float> re_, im_;         // [channel][bin, padded]
  Grid<float> patterns_;        // [distance][column]
};

}  // namespace odas
