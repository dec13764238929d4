// SPDX-License-Identifier: MIT
#include "odas/localization/search_plan.hpp"

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::search_plan_test {
namespace {

/// The closed array of the ODAS paper: two microphones on each side of a square body.
GeneralConfig closed_square() {
  GeneralConfig config;
  for (const Vec3 side : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}}) {
    const Vec3 along = cross({0, 0, 1}, side);
    for (const float offset : {-0.05F, 0.05F}) {
      config.mics.push_back(test::mic_at(0.15F * side + offset * along, side, {80, 90}));
    }
  }
  config.spatialfilters.emplace();
  return config;
}

TEST(SearchPlan, Prunes_the_pairs_that_hear_no_common_direction) {
  const SearchPlan plan(closed_square(), {});
  EXPECT_EQ(plan.summary.pairs, 28U);
  ASSERT_EQ(plan.pairs.size(), 20U);
  for (const Pair& pair : plan.pairs) {
    const std::size_t sides_apart = (pair.j / 2 + 4 - pair.i / 2) % 4;
    EXPECT_NE(sides_apart, 2U) << "microphones " << pair.i << " and " << pair.j << " face opposite ways";
  }
}

TEST(SearchPlan, Keeps_every_pair_of_an_open_array) {
  const SearchPlan plan(test::ring(8, 0.1F), {});
  EXPECT_EQ(plan.pairs.size(), 28U);
}

TEST(SearchPlan, Of_a_flat_array_searches_half_the_sphere_unless_told_otherwise) {
  GeneralConfig general = test::ring(4, 0.03F);
  const SearchPlan full(general, {});
  general.spatialfilters.reset();
  const SearchPlan half(general, {});
  EXPECT_FALSE(full.summary.half_sphere);
  EXPECT_TRUE(half.summary.half_sphere);
  EXPECT_NEAR(full.summary.heard_share, 1, 1e-9);
  EXPECT_NEAR(half.summary.heard_share, 0.5, 0.03);
}

TEST(SearchPlan, Refuses_an_array_that_hears_nothing) {
  GeneralConfig general;
  general.mics = {test::mic_at({0, 0, 0.1F}, {0, 0, 1}, {30, 40}),
                  test::mic_at({0, 0, -0.1F}, {0, 0, -1}, {30, 40})};
  general.spatialfilters.emplace();
  EXPECT_THROW(SearchPlan(general, {}), ConfigError);
}

TEST(SearchPlan, Has_a_way_from_every_coarse_winner_to_the_finest_grid) {
  const SearchPlan plan(closed_square(), {});
  for (const std::uint32_t winner : plan.levels[0].cells[0].points) {
    EXPECT_FALSE(plan.levels[1].cells[winner].points.empty()) << winner;
  }
}

}  // namespace
}  // namespace odas::search_plan_test
