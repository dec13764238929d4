// SPDX-License-Identifier: MIT
#include "odas/tracking/simd.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace odas::simd_test {
namespace {

TEST(ExpMinus, is_right_to_1e_5_of_itself) {
  for (float x = 0; x < 60; x += 0.00731F) {
    const auto expected = std::exp(-static_cast<double>(x));
    const Floats got = exp_minus(Floats{x, 0, x, x});
    ASSERT_NEAR(static_cast<double>(got[0]) / expected, 1, 1e-5) << x;
    ASSERT_EQ(got[1], 1.F);
  }
}

TEST(ExpMinus, is_small_and_no_denormal_far_off) {
  const Floats got = exp_minus(
      Floats{100, 1e30F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()});
  for (int lane = 0; lane < kLanes; ++lane) {
    EXPECT_LT(got[lane], 1e-25F);
    EXPECT_GT(got[lane], 1e-27F);
  }
}

TEST(Simd, sums_four_numbers) { EXPECT_EQ(sum_of(Floats{1, 2, 4, 8}), 15.F); }

}  // namespace
}  // namespace odas::simd_test
