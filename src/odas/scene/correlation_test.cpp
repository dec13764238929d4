// SPDX-License-Identifier: MIT
#include "odas/scene/correlation.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace odas::correlation_test {
namespace {

std::vector<float> noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> x(size);
  for (float& v : x) v = static_cast<float>(random() % 2001) / 1000 - 1;
  return x;
}

float at(const std::vector<float>& x, long n) {
  return n >= 0 && n < static_cast<long>(x.size()) ? x[static_cast<std::size_t>(n)] : 0.F;
}

TEST(Correlation, is_the_sum_of_products_at_every_lag_and_length) {
  for (const std::size_t length_a : {1U, 50U, 333U, 2000U}) {
    for (const std::size_t length_b : {1U, 64U, 999U}) {
      for (const long first : {-40L, 0L, 7L}) {
        const auto a = noise(length_a, 1);
        const auto b = noise(length_b, 2);
        const auto c = correlate(a, b, first, 77);
        ASSERT_EQ(c.size(), 77U);
        for (std::size_t i = 0; i < c.size(); ++i) {
          double sum = 0;
          for (std::size_t n = 0; n < b.size(); ++n) {
            sum += static_cast<double>(at(a, static_cast<long>(n + i) + first)) * static_cast<double>(b[n]);
          }
          EXPECT_NEAR(c[i], sum, 1e-4);
        }
      }
    }
  }
}

TEST(BestLag, finds_how_much_later_a_sound_comes_also_upside_down) {
  const auto sound = noise(5000, 3);
  std::vector<float> later(6000, 0.F);
  for (std::size_t n = 0; n < sound.size(); ++n) later[n + 391] = -0.3F * sound[n];
  EXPECT_EQ(best_lag(later, sound, 8192), 391U);
}

TEST(Filter, is_the_convolution_with_its_taps) {
  const auto x = noise(1500, 4);
  std::vector<double> taps(33);
  for (std::size_t k = 0; k < taps.size(); ++k) taps[k] = std::sin(static_cast<double>(k * k));
  for (const std::size_t advance : {0U, 16U}) {
    const auto y = filter(x, taps, advance);
    ASSERT_EQ(y.size(), x.size());
    for (std::size_t n = 0; n < y.size(); n += 7) {
      double sum = 0;
      for (std::size_t k = 0; k < taps.size(); ++k) {
        sum += taps[k] * static_cast<double>(at(x, static_cast<long>(n + advance) - static_cast<long>(k)));
      }
      EXPECT_NEAR(static_cast<double>(y[n]), sum, 1e-4);
    }
  }
}

}  // namespace
}  // namespace odas::correlation_test
