// SPDX-License-Identifier: MIT
#include "odas/separation/hann_smoother.hpp"

#include <algorithm>
#include <cmath>

#include "odas/base/contract.hpp"

namespace odas {

namespace {

constexpr std::size_t kNarrow = 8;  // up to here, summing costs less than sliding

}  // namespace

HannSmoother::HannSmoother(std::size_t width, std::size_t frame_size)
    : width_(width),
      window_(width),
      cosines_(width + 1),
      sines_(width + 1),
      sources_(frame_size / 2 + width),
      extended_(sources_.size()) {
  const auto turn = static_cast<double>(width + 1);
  for (std::size_t i = 0; i <= width; ++i) {
    const double phase = 2 * M_PI * static_cast<double>(i) / turn;
    cosines_[i] = std::cos(phase);
    sines_[i] = std::sin(phase);
  }
  for (std::size_t i = 0; i < width; ++i) window_[i] = static_cast<float>((1 - cosines_[i + 1]) / turn);
  const std::size_t first = frame_size - (width - 1 - width / 2);  // of the window of bin 0
  for (std::size_t j = 0; j < sources_.size(); ++j) {
    const std::size_t n = (first + j) % frame_size;
    sources_[j] = static_cast<std::uint32_t>(n <= frame_size / 2 ? n : frame_size - n);
  }
}

void HannSmoother::smooth(std::span<const float> values, std::span<float> smoothed) noexcept {
  ODAS_EXPECT(values.size() + width_ - 1 == extended_.size() && smoothed.size() == values.size());
  for (std::size_t j = 0; j < extended_.size(); ++j) extended_[j] = values[sources_[j]];
  if (width_ <= kNarrow) {
    sum_up(smoothed);
  } else {
    slide(smoothed);
  }
}

void HannSmoother::sum_up(std::span<float> smoothed) const noexcept {
  std::fill(smoothed.begin(), smoothed.end(), 0.F);
  for (std::size_t i = 0; i < width_; ++i) {
    for (std::size_t k = 0; k < smoothed.size(); ++k) smoothed[k] += window_[i] * extended_[k + i];
  }
}

void HannSmoother::slide(std::span<float> smoothed) const noexcept {
  // y[k] = sum over the last `width` values up to j = k + width - 1 of x[j] (1 - cos w (j0 - j)) / (width +
  // 1), j0 = k + width, and cos w (j0 - j) = cos w j0 cos w j + sin w j0 sin w j.
  const std::size_t turn = width_ + 1;
  const double scale = 1 / static_cast<double>(turn);
  double sum = 0;
  double by_cosine = 0;
  double by_sine = 0;
  const auto weigh = [&](double value, std::size_t phase) {
    sum += value;
    by_cosine += value * cosines_[phase];
    by_sine += value * sines_[phase];
  };
  const std::size_t before = width_ - 1;
  for (std::size_t j = 0; j < before; ++j) weigh(static_cast<double>(extended_[j]), j);
  std::size_t leaving = 0;  // phases of the value that leaves, of the one that enters, and of the next one
  std::size_t entering = before;
  std::size_t next = width_;
  const auto rotate = [turn](std::size_t& phase) { phase = phase + 1 == turn ? 0 : phase + 1; };
  for (std::size_t k = 0; k < smoothed.size(); ++k) {
    weigh(static_cast<double>(extended_[k + before]), entering);
    const double y = (sum - cosines_[next] * by_cosine - sines_[next] * by_sine) * scale;
    smoothed[k] = std::max(0.F, static_cast<float>(y));
    weigh(-static_cast<double>(extended_[k]), leaving);
    rotate(leaving);
    rotate(entering);
    rotate(next);
  }
}

}  // namespace odas
