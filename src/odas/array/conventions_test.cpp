// SPDX-License-Identifier: MIT
// Claims of conventions.md.
#include <gtest/gtest.h>

#include "odas/base/vec3.hpp"

namespace odas::conventions_test {
namespace {

TEST(Conventions, Azimuth_turns_from_x_to_y_and_elevation_rises_to_z) {
  EXPECT_NEAR(azimuth_deg({1, 0, 0}), 0, 1e-5);
  EXPECT_NEAR(azimuth_deg({0, 1, 0}), 90, 1e-5);
  EXPECT_NEAR(azimuth_deg({0, -1, 0}), -90, 1e-5);
  EXPECT_NEAR(elevation_deg({0, 0, 1}), 90, 1e-5);
  EXPECT_NEAR(elevation_deg({1, 0, -1}), -45, 1e-4);
}

TEST(Conventions, Angles_and_directions_are_inverse) {
  for (float az = -179; az < 180; az += 13) {
    for (float el = -89; el < 90; el += 11) {
      const Vec3 u = direction_of(az, el);
      EXPECT_NEAR(norm(u), 1, 1e-6);
      EXPECT_NEAR(azimuth_deg(u), az, 1e-3);
      EXPECT_NEAR(elevation_deg(u), el, 1e-3);
    }
  }
}

TEST(Conventions, The_frame_is_right_handed) { EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1})); }

}  // namespace
}  // namespace odas::conventions_test
