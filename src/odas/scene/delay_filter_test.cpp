// SPDX-License-Identifier: MIT
#include "odas/scene/delay_filter.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace odas::delay_filter_test {
namespace {

std::complex<double> response_at(const std::vector<float>& h, double omega) {
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < h.size(); ++n) {
    sum += static_cast<double>(h[n]) * std::polar(1.0, -omega * static_cast<double>(n));
  }
  return sum;
}

TEST(DelayFilter, Is_a_pure_delay_to_60_dB_up_to_three_quarters_of_the_band) {
  const DelayFilter filter;
  for (const float delay : {40.F, 40.25F, 40.5F, 40.773F, 41.999F}) {
    std::vector<float> h(100);
    filter.add(delay, 0.5F, h);
    for (double share = 0; share <= 0.751; share += 0.05) {
      const double omega = share * std::numbers::pi;
      const auto ideal = std::polar(0.5, -omega * static_cast<double>(delay));
      EXPECT_LT(std::abs(response_at(h, omega) - ideal) / 0.5, 1e-3) << delay << " at " << share;
    }
    const double omega = 0.85 * std::numbers::pi;
    EXPECT_LT(std::abs(response_at(h, omega) - std::polar(0.5, -omega * static_cast<double>(delay))) / 0.5,
              6e-3);
  }
}

TEST(DelayFilter, A_whole_delay_is_one_sample) {
  const DelayFilter filter;
  std::vector<float> h(100);
  filter.add(50, 2, h);
  for (std::size_t n = 0; n < h.size(); ++n) EXPECT_NEAR(h[n], n == 50 ? 2 : 0, 1e-6);
}

TEST(DelayFilter, Loses_what_lies_outside_and_keeps_the_rest) {
  const DelayFilter filter;
  std::vector<float> whole(200);
  std::vector<float> begin(60);
  filter.add(103.3F, 1, whole);
  filter.add(3.3F, 1, begin);
  for (std::size_t n = 0; n < 23; ++n) EXPECT_NEAR(begin[n], whole[n + 100], 1e-4);
  std::vector<float> end(105);
  filter.add(103.3F, 1, end);
  for (std::size_t n = 0; n < end.size(); ++n) EXPECT_FLOAT_EQ(end[n], whole[n]);
}

}  // namespace
}  // namespace odas::delay_filter_test
