// SPDX-License-Identifier: MIT
#include "odas/separation/stillness.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

namespace odas::stillness_test {
namespace {

constexpr float kHop = 0.008F;
constexpr float kForever = std::numeric_limits<float>::infinity();

/// What it says after `seconds` of a talker who is at where(time).
float after(Stillness& stillness, float seconds, const std::function<Vec3(float)>& where) {
  for (float t = 0; t < seconds; t += kHop) {
    const std::array tracks{test::track(1, where(t)), Track{}};
    stillness.update(tracks);
  }
  return stillness.seconds();
}

Vec3 walker(float t) { return direction_of(10 * t, 10); }
Vec3 stander(float /*t*/) { return direction_of(70, 10); }

class StillnessTest : public ::testing::Test {
 protected:
  Stillness stillness{test::ring(7, 0.04F), 2};
};

TEST_F(StillnessTest, NobodyWalks) { EXPECT_EQ(after(stillness, 3, stander), kForever); }

TEST_F(StillnessTest, OneWhoWalksIsSeenWithinTwoSeconds) {
  EXPECT_EQ(after(stillness, 0.5F, walker), kForever);
  EXPECT_EQ(after(stillness, 1.5F, [](float t) { return walker(0.5F + t); }), 0);
}

TEST_F(StillnessTest, CountsFromWhenHeStops) {
  after(stillness, 3, walker);
  const float stopped = after(stillness, 8, [](float) { return walker(3); });
  EXPECT_GT(stopped, 5);
  EXPECT_LT(stopped, 8);
}

TEST_F(StillnessTest, AnEstimateThatWaversStandsStill) {
  EXPECT_EQ(after(stillness, 5, [](float t) { return direction_of(70 + 5 * std::sin(9 * t), 10); }),
            kForever);
}

TEST_F(StillnessTest, AFlatArrayDoesNotSeeElevation) {
  EXPECT_EQ(after(stillness, 3, [](float t) { return direction_of(70, 6 * t); }), kForever);
}

TEST_F(StillnessTest, AnotherInTheSamePlaceHasNotWalked) {
  after(stillness, 1, stander);
  const std::array tracks{test::track(2, direction_of(-90, 0)), Track{}};
  stillness.update(tracks);
  EXPECT_EQ(stillness.seconds(), kForever);
}

TEST_F(StillnessTest, ADirectionThatIsNotFiniteIsPassedOver) {
  after(stillness, 1, [](float) { return Vec3{std::nanf(""), 0, 0}; });
  EXPECT_LT(after(stillness, 3, walker), 0.5F);
  stillness.reset();
  after(stillness, 0.1F, stander);
  after(stillness, 0.1F, [](float) { return Vec3{kForever, 0, 0}; });
  EXPECT_LT(after(stillness, 3, walker), 0.5F);
}

TEST_F(StillnessTest, ResetForgetsWhoWalked) {
  ASSERT_EQ(after(stillness, 3, walker), 0);
  stillness.reset();
  EXPECT_EQ(stillness.seconds(), kForever);
}

}  // namespace
}  // namespace odas::stillness_test
