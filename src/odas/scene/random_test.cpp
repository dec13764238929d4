// SPDX-License-Identifier: MIT
#include "odas/scene/random.hpp"

#include <gtest/gtest.h>

namespace odas::random_test {
namespace {

// mt19937's outputs are fixed by the standard, and so, with nothing but a shift, a difference and a product
// after them, are these.
TEST(Random, Gives_the_numbers_that_it_gives_everywhere) {
  std::mt19937 standard(5489);
  Random random(5489);
  constexpr float kStep = 3.46410161513775F / 16777216.F;
  EXPECT_FLOAT_EQ(random.uniform(), (static_cast<float>(3499211612U >> 8U) - 8388607.5F) * kStep);
  standard.discard(1);
  EXPECT_FLOAT_EQ(random.uniform(), (static_cast<float>(standard() >> 8U) - 8388607.5F) * kStep);
}

TEST(Random, Has_mean_0_and_variance_1) {
  Random random(7);
  double sum = 0;
  double square = 0;
  constexpr int kCount = 200000;
  for (int n = 0; n < kCount; ++n) {
    const double x = random.uniform();
    sum += x;
    square += x * x;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.01);
  EXPECT_NEAR(square / kCount, 1, 0.01);
}

TEST(Random, Parts_of_a_scene_draw_different_numbers) {
  EXPECT_NE(Random::of(1, 0).uniform(), Random::of(1, 1).uniform());
  EXPECT_NE(Random::of(1, 0).uniform(), Random::of(2, 0).uniform());
  EXPECT_EQ(Random::of(2, 3).uniform(), Random::of(2, 3).uniform());
}

}  // namespace
}  // namespace odas::random_test
