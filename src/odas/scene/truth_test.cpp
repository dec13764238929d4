// SPDX-License-Identifier: MIT
#include "odas/scene/truth.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace odas::truth_test {
namespace {

Direction at(double azimuth, double elevation) {
  const double a = azimuth * M_PI / 180;
  const double e = elevation * M_PI / 180;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

TEST(Distance, of_azimuth_goes_the_short_way_round_and_does_not_see_elevation) {
  EXPECT_NEAR(distance_deg(Measure::azimuth, at(170, 0), at(-170, 60)), 20, 1e-9);
  EXPECT_NEAR(distance_deg(Measure::azimuth, at(-10, 5), at(15, -5)), 25, 1e-9);
}

TEST(Distance, of_angle_is_along_the_great_circle) {
  EXPECT_NEAR(distance_deg(Measure::angle, at(20, 10), at(20, 55)), 45, 1e-9);
  EXPECT_NEAR(distance_deg(Measure::angle, at(0, 45), at(180, 45)), 90, 1e-9);
}

TEST(Distance, of_a_direction_to_itself_is_zero_though_rounding_makes_it_longer_than_one) {
  const Direction printed{0.578, 0.578, 0.578};
  EXPECT_EQ(distance_deg(Measure::angle, printed, printed), 0);
}

}  // namespace
}  // namespace odas::truth_test
