// SPDX-License-Identifier: MIT
#include "odas/tracking/normal_noise.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace odas::normal_noise_test {
namespace {

TEST(NormalNoise, has_mean_0_variance_1_and_tails_that_end) {
  NormalNoise noise(1);
  constexpr int kDraws = 250000;
  double sum = 0, squares = 0, fourths = 0, greatest = 0;
  for (int i = 0; i < kDraws; ++i) {
    const Floats four = noise();
    for (int lane = 0; lane < kLanes; ++lane) {
      const auto x = static_cast<double>(four[lane]);
      sum += x;
      squares += x * x;
      fourths += x * x * x * x;
      greatest = std::max(greatest, std::abs(x));
    }
  }
  const double n = kLanes * kDraws;
  EXPECT_NEAR(sum / n, 0, 0.005);
  EXPECT_NEAR(squares / n, 1, 0.005);
  EXPECT_NEAR(fourths / n, 2.7, 0.02) << "3 for a Gaussian";
  EXPECT_LE(greatest, 3.4642);
  EXPECT_GT(greatest, 3.2);
}

TEST(NormalNoise, is_not_the_same_from_draw_to_draw_nor_from_lane_to_lane) {
  NormalNoise noise(1);
  constexpr int kDraws = 100000;
  Floats last = noise();
  double in_time = 0, across = 0;
  for (int i = 0; i < kDraws; ++i) {
    const Floats now = noise();
    in_time += static_cast<double>(now[0] * last[0]);
    across += static_cast<double>(now[0] * now[1]);
    last = now;
  }
  EXPECT_NEAR(in_time / kDraws, 0, 0.015);
  EXPECT_NEAR(across / kDraws, 0, 0.015);
}

TEST(NormalNoise, gives_the_bits_that_it_gave_on_the_first_machine) {
  NormalNoise noise(1);
  const Floats first = noise();
  EXPECT_EQ(first[0], -1.66584611F);
  EXPECT_EQ(first[3], 0.384066194F);
  for (int i = 0; i < 1000; ++i) (void)noise();
  EXPECT_EQ(noise()[2], -0.191821665F);
  EXPECT_EQ(noise.uniform(), 0.519932866F);
}

TEST(NormalNoise, depends_on_its_seed) {
  NormalNoise one(1);
  NormalNoise two(2);
  EXPECT_NE(one()[0], two()[0]);
}

TEST(NormalNoise, uniform_numbers_fill_the_unit_interval) {
  NormalNoise noise(5);
  std::vector<int> counts(10);
  for (int i = 0; i < 100000; ++i) {
    const float u = noise.uniform();
    ASSERT_TRUE(u >= 0 && u < 1);
    ++counts[static_cast<std::size_t>(10 * u)];
  }
  for (const int count : counts) EXPECT_NEAR(count, 10000, 500);
}

}  // namespace
}  // namespace odas::normal_noise_test
