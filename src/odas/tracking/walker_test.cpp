// SPDX-License-Identifier: MIT
#include "odas/tracking/walker.hpp"

#include <cmath>
#include <random>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::walker_test {
namespace {

constexpr double kHop = 0.008;
constexpr TangentCovariance kSharp{0.001F, 0.001F, 0};
constexpr TangentCovariance kFlat{0.001F, 0.07F, 0};  // sigma 1.8 and 15 degrees

double in_degrees(double radians) { return radians * 180 / M_PI; }

/// Hears somebody from `from` on, turning at `speed` degrees/s.
void hear(Walker& walker, float from, float elevation, float speed, double seconds) {
  std::mt19937 random(5);
  std::normal_distribution<float> jitter(0, 1.8F);
  for (int h = 0; h * kHop < seconds; ++h) {
    walker.predict();
    const auto turned = from + speed * static_cast<float>(h * kHop);
    const Vec3 z = direction_of(turned + jitter(random), elevation + jitter(random));
    walker.observe(walker.offset_of(z), kSharp, 1.0 / 6);
    walker.settle();
  }
}

TEST(Walker, offset_is_azimuth_on_the_sphere_and_elevation) {
  Walker walker(kHop);
  walker.start(direction_of(170, 60), kSharp);
  const auto apart = walker.offset_of(direction_of(-170, 10));
  EXPECT_NEAR(in_degrees(apart.east), 20 * std::cos(M_PI / 3), 1e-3);
  EXPECT_NEAR(in_degrees(apart.north), -50, 1e-3);
}

TEST(Walker, offset_over_the_pole_is_as_long_as_the_arc_and_the_other_pole_is_far) {
  Walker walker(kHop);
  walker.start(direction_of(10, 85), kSharp);
  const auto over = walker.offset_of(direction_of(190, 80));
  EXPECT_NEAR(in_degrees(std::hypot(over.east, over.north)), 15, 0.01);
  const auto away = walker.offset_of(direction_of(190, -85));
  EXPECT_NEAR(in_degrees(std::hypot(away.east, away.north)), 180, 0.1);
}

TEST(Walker, knows_one_who_stands_from_one_who_walks) {
  Walker stands(kHop);
  stands.start(direction_of(40, 10), kSharp);
  hear(stands, 40, 10, 0, 3);
  EXPECT_LT(test::angle_deg(stands.direction(), direction_of(40, 10)), 1.5F);
  Walker walks(kHop);
  walks.start(direction_of(40, 10), kSharp);
  hear(walks, 40, 10, 15, 3);
  EXPECT_LT(test::angle_deg(walks.direction(), direction_of(85, 10)), 3);
  EXPECT_GT(walks.walking(), stands.walking());
  EXPECT_NEAR(in_degrees(walks.turning()), 15 * std::cos(M_PI / 18), 5);
}

TEST(Walker, gets_less_sure_while_nobody_is_heard_and_walks_on_for_a_while) {
  Walker walker(kHop);
  walker.start(direction_of(0, 0), kSharp);
  hear(walker, 0, 0, 15, 3);
  const auto before = walker.covariance();
  for (int h = 0; h < 60; ++h) {
    walker.predict();
    walker.settle();
  }
  EXPECT_GT(walker.covariance().east, before.east);
  EXPECT_GT(azimuth_deg(walker.direction()), 45 + 2);
}

TEST(Walker, stays_where_it_was_when_it_is_not_thought_to_go_on) {
  Walker walker(kHop);
  walker.start(direction_of(0, 10), kSharp);
  hear(walker, 0, 10, 20, 3);
  const Vec3 last = walker.direction();
  for (int h = 0; h < 100; ++h) {
    walker.predict(false);
    walker.settle();
  }
  EXPECT_LT(std::abs(in_degrees(walker.offset_of(last).east)), 1);
  EXPECT_GT(walker.turning(), 0);
}

TEST(Walker, forgives_elevation_where_it_is_badly_heard_and_azimuth_not) {
  Walker walker(kHop);
  walker.start(direction_of(0, 20), kFlat);
  const auto density = [&](float azimuth, float elevation) {
    return walker.fit(walker.offset_of(direction_of(azimuth, elevation)), kFlat).density;
  };
  EXPECT_GT(density(0, 35), 0.5 * density(0, 20));
  EXPECT_LT(density(15, 20), 0.05 * density(0, 20));
}

}  // namespace
}  // namespace odas::walker_test
