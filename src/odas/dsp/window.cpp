// SPDX-License-Identifier: MIT
#include "odas/dsp/window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odas {

std::vector<float> root_hann(std::size_t frame_size) {
  std::vector<float> window(frame_size);
  const double step = frame_size > 1 ? 2 * std::numbers::pi / static_cast<double>(frame_size - 1) : 0;
  for (std::size_t n = 0; n < frame_size; ++n) {
    window[n] = static_cast<float>(std::sqrt(0.5 * (1 - std::cos(step * static_cast<double>(n)))));
  }
  return window;
}

std::vector<float> synthesis_window(const std::vector<float>& analysis, std::size_t hop_size) {
  std::vector<double> sum(hop_size, 0);
  for (std::size_t n = 0; n < analysis.size(); ++n) {
    sum[n % hop_size] += static_cast<double>(analysis[n]) * static_cast<double>(analysis[n]);
  }
  // Where frames hardly overlap, what the window took away is not brought back in full: that would blow up
  // what a changed spectrum leaves at the ends of a frame.
  constexpr double kLeast = 0.5;
  std::vector<float> window(analysis.size());
  for (std::size_t n = 0; n < analysis.size(); ++n) {
    window[n] = static_cast<float>(static_cast<double>(analysis[n]) / std::max(sum[n % hop_size], kLeast));
  }
  return window;
}

}  // namespace odas
