// SPDX-License-Identifier: MIT
#include "odas/scene/trajectory.hpp"

#include <gtest/gtest.h>

namespace odas::trajectory_test {
namespace {

const std::vector<Waypoint> kWalk{{1, -20, 0, 1}, {3, 20, 10, 2}, {4, 20, 10, 1}};

TEST(Trajectory, Goes_straight_between_waypoints) {
  const Waypoint half = waypoint_at(kWalk, 2);
  EXPECT_FLOAT_EQ(half.azimuth, 0);
  EXPECT_FLOAT_EQ(half.elevation, 5);
  EXPECT_FLOAT_EQ(half.distance, 1.5);
  EXPECT_FLOAT_EQ(waypoint_at(kWalk, 3.5).distance, 1.5);
}

TEST(Trajectory, Rests_before_the_first_and_after_the_last_waypoint) {
  EXPECT_FLOAT_EQ(waypoint_at(kWalk, 0).azimuth, -20);
  EXPECT_FLOAT_EQ(waypoint_at(kWalk, 9).distance, 1);
}

TEST(Trajectory, Position_is_direction_times_distance) {
  const Vec3 u = direction_at(kWalk, 2.5);
  const Vec3 p = position_at(kWalk, 2.5);
  EXPECT_NEAR(norm(u), 1, 1e-6);
  EXPECT_NEAR(norm(p), 1.75, 1e-6);
  EXPECT_NEAR(azimuth_deg(p), 10, 1e-4);
  EXPECT_NEAR(elevation_deg(p), 7.5, 1e-4);
}

TEST(Trajectory, Knows_who_is_at_rest) {
  EXPECT_FALSE(is_at_rest(kWalk));
  EXPECT_TRUE(is_at_rest(std::vector<Waypoint>{{0, 5, 6, 7}, {9, 5, 6, 7}}));
}

}  // namespace
}  // namespace odas::trajectory_test
