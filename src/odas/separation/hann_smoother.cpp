// SPDX-License-Identifier: MIT
#include "odas/separation/hann_smoother.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"

namespace odas {

HannSmoother::HannSmoother(std::size_t width, std::size_t frame_size)
    : width_(width), frame_size_(frame_size), cosines_(width + 1), sines_(width + 1) {
  for (std::size_t i = 0; i <= width; ++i) {
    const double phase = 2 * M_PI * static_cast<double>(i) / static_cast<double>(width + 1);
    cosines_[i] = std::cos(phase);
    sines_[i] = std::sin(phase);
  }
}

void HannSmoother::smooth(std::span<const float> values, std::span<float> smoothed) const noexcept {
  ODAS_EXPECT(values.size() == frame_size_ / 2 + 1 && smoothed.size() == values.size());
  // y[k] = sum over the last `width` values up to j = k + width / 2 of x[j] (1 - cos w (j0 - j)) / (width +
  // 1), j0 = k + width / 2 + 1, and cos w (j0 - j) = cos w j0 cos w j + sin w j0 sin w j. Phases count from
  // the first value that enters, so that j is never negative.
  const std::size_t turn = width_ + 1;
  const std::size_t ahead = width_ / 2;
  const std::size_t first = frame_size_ - (width_ - 1 - ahead);  // of the window of bin 0
  const auto at = [&](std::size_t j) {
    const std::size_t n = (first + j) % frame_size_;
    return static_cast<double>(values[n <= frame_size_ / 2 ? n : frame_size_ - n]);
  };

  double sum = 0;
  double by_cosine = 0;
  double by_sine = 0;
  const std::size_t entered_before = width_ - 1;
  for (std::size_t j = 0; j < entered_before + values.size(); ++j) {
    const double entering = at(j);
    const std::size_t phase = j % turn;
    sum += entering;
    by_cosine += entering * cosines_[phase];
    by_sine += entering * sines_[phase];
    if (j < entered_before) continue;
    const std::size_t next = (j + 1) % turn;
    const double y = (sum - cosines_[next] * by_cosine - sines_[next] * by_sine) / static_cast<double>(turn);
    smoothed[j - entered_before] = std::max(0.F, static_cast<float>(y));
    const double leaving = at(j - entered_before);
    const std::size_t left = (j - entered_before) % turn;
    sum -= leaving;
    by_cosine -= leaving * cosines_[left];
    by_sine -= leaving * sines_[left];
  }
}

}  // namespace odas
