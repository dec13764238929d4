// SPDX-License-Identifier: MIT
#include "odas/separation/hann_smoother.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace odas::hann_smoother_test {
namespace {

/// The definition: y[k] = sum_i h[i] x[k - (i - width / 2)] over the whole spectrum of `frame` points.
std::vector<double> oracle(std::span<const float> half, std::size_t width, std::size_t frame) {
  std::vector<double> window(width);
  double total = 0;
  for (std::size_t i = 0; i < width; ++i) {
    window[i] = 1 - std::cos(2 * M_PI * static_cast<double>(i + 1) / static_cast<double>(width + 1));
    total += window[i];
  }
  std::vector<double> out(half.size());
  for (std::size_t k = 0; k < half.size(); ++k) {
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t n = (k + 2 * frame + width / 2 - i) % frame;
      out[k] += window[i] / total * static_cast<double>(half[n < half.size() ? n : frame - n]);
    }
  }
  return out;
}

TEST(HannSmoother, equals_the_circular_convolution) {
  std::mt19937 random(3);
  std::lognormal_distribution<float> decades(0, 6);
  for (const std::size_t frame : {2U, 8U, 256U}) {
    for (std::size_t width = 1; width <= frame; width += width < 25 ? 1 : 77) {
      std::vector<float> values(frame / 2 + 1);
      for (float& v : values) v = decades(random);
      std::vector<float> smoothed(values.size());
      HannSmoother(width, frame).smooth(values, smoothed);
      const auto expected = oracle(values, width, frame);
      for (std::size_t k = 0; k < values.size(); ++k) {
        EXPECT_NEAR(smoothed[k], expected[k], 1e-6 * expected[k] + 1e-9)
            << "width " << width << " of " << frame << ", bin " << k;
      }
    }
  }
}

TEST(HannSmoother, leaves_a_flat_spectrum_flat) {
  const std::vector<float> flat(129, 3);
  std::vector<float> smoothed(129);
  for (const std::size_t width : {1U, 3U, 23U, 256U}) {
    HannSmoother(width, 256).smooth(flat, smoothed);
    for (const float y : smoothed) EXPECT_NEAR(y, 3, 1e-5) << width;
  }
}

}  // namespace
}  // namespace odas::hann_smoother_test
