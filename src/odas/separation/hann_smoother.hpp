// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace odas {

/// Smooths a half spectrum over frequency: circular convolution of the whole spectrum, which mirrors itself,
/// with a Hann window of `width` points (without its zero ends) whose sum is 1.
///
/// Method: a Hann window is a constant less a cosine, so one running sum of the values and one of the values
///   times a rotating phase do for any width; in double, for the values may span many decades. A narrow
///   window is summed as it is. Cost: O(frame + width).
/// Shapes: [bin], bin = frame / 2 + 1.
class HannSmoother {
 public:
  /// `width` is at most `frame_size`, which is even.
  HannSmoother(std::size_t width, std::size_t frame_size);

  [[nodiscard]] std::size_t width() const noexcept { return width_; }

  void smooth(std::span<const float> values, std::span<float> smoothed) noexcept;

 private:
  void sum_up(std::span<float> smoothed) const noexcept;
  void slide(std::span<float> smoothed) const noexcept;

  std::size_t width_;
  std::vector<float> window_;           // [width]
  std::vector<double> cosines_;         // [width + 1]: one turn
  std::vector<double> sines_;           // [width + 1]
  std::vector<std::uint32_t> sources_;  // [bin + width - 1]: the bin that stands there
  std::vector<float> extended_;         // [bin + width - 1]: the values, mirrored at both ends
};

}  // namespace odas
