// SPDX-License-Identifier: MIT
#include "odas/dsp/real_fft.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace odas::real_fft_test {
namespace {

class RealFftSizes : public ::testing::TestWithParam<std::size_t> {};

std::vector<float> noise(std::size_t n) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  std::vector<float> x(n);
  for (float& v : x) v = normal(random);
  return x;
}

TEST_P(RealFftSizes, Forward_agrees_with_the_sum_that_defines_it) {
  const std::size_t n = GetParam();
  RealFft fft(n);
  const auto x = noise(n);
  std::copy(x.begin(), x.end(), fft.time().begin());
  fft.forward();
  for (std::size_t k = 0; k <= n / 2; ++k) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = -2 * std::numbers::pi * static_cast<double>(k * i % n) / static_cast<double>(n);
      sum += static_cast<double>(x[i]) * std::polar(1.0, angle);
    }
    EXPECT_NEAR(fft.bins()[k].real(), sum.real(), 1e-4) << k;
    EXPECT_NEAR(fft.bins()[k].imag(), sum.imag(), 1e-4) << k;
  }
}

TEST_P(RealFftSizes, Inverse_undoes_forward) {
  const std::size_t n = GetParam();
  RealFft fft(n);
  const auto x = noise(n);
  std::copy(x.begin(), x.end(), fft.time().begin());
  fft.forward();
  fft.inverse();
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(fft.time()[i], x[i], 1e-5) << i;
}

INSTANTIATE_TEST_SUITE_P(Sizes, RealFftSizes, ::testing::Values(2, 6, 90, 256, 882, 1024));

}  // namespace
}  // namespace odas::real_fft_test
