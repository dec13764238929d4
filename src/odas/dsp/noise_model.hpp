// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// The bins from 200 Hz to 7 kHz (or what there is of it): below, arrays of this size hear no direction.
struct BinRange {
  std::size_t first, last;  // both counted
};
[[nodiscard]] BinRange telling_bins(int sample_rate, std::size_t frame_size) noexcept;

/// How likely spectra are under the spatial covariance of a noise, whatever their level.
///
/// Method: in each bin the covariance D, loaded by a thousandth of its trace and scaled to determinant 1; the
/// log-density of a direction in space of M microphones is that of the complex angular Gaussian,
///   likeness = - mean over bins of ln(x^H D^-1 x / x^H x).
/// 0 for a diffuse D, larger the better the noise points where D says.
/// Source: Ito, Araki and Nakatani, "Complex angular central Gaussian mixture model for directional
///   statistics in mask-based microphone array signal processing", 2016, less the factor M.
/// Cost per call: M^2 / 2 complex products and a logarithm per bin.
class NoiseModel {
 public:
  /// `scm`: [bin][mic][mic]. Only `bins` count.
  NoiseModel(std::span<const cfloat> scm, std::size_t mics, BinRange bins);

  /// spectra [mic][bin]. Not finite where they are not.
  [[nodiscard]] float likeness(GridView<const cfloat> spectra) const noexcept;
  /// The same of averaged spectra, [bin][mic][mic], with tr(D^-1 R) for x^H D^-1 x.
  [[nodiscard]] float likeness(std::span<const cfloat> scm) const noexcept;

 private:
  std::size_t mics_;
  BinRange bins_;
  std::vector<cfloat> inverses_;  // [bin][mic][mic]: D^-1
};

}  // namespace odas
