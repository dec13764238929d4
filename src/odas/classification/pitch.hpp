// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/dsp/real_fft.hpp"

namespace odas {

/// The pitch period of a frame of sound.
///
/// Method: r = inverse DFT of |X|^2, X the DFT of the frame under a root-Hann window; the highest of those
/// r[i]
///   that exceed all neighbours within `reach`, reach <= i <= N / 2 - reach; refined by a parabola.
/// Source: ODAS 10. Departs: a peak under `voicing` times that of a perfectly periodic sound is none: noise
///   has peaks too.
/// Units: samples. Cost: two transforms of N points.
class PitchDetector {
 public:
  /// `frame_size` is even.
  PitchDetector(std::size_t frame_size, std::size_t reach, float voicing);

  /// 0: no pitch. `frame` has N samples.
  [[nodiscard]] float period(std::span<const float> frame) noexcept;

 private:
  [[nodiscard]] std::size_t highest_peak(std::span<const float> r) const noexcept;

  std::size_t reach_;
  RealFft fft_;
  std::vector<float> window_;
  std::vector<float> least_;  // [lag]: of r[lag] / r[0], for a pitch
};

}  // namespace odas
