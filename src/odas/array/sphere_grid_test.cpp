// SPDX-License-Identifier: MIT
#include "odas/array/sphere_grid.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace odas::sphere_grid_test {
namespace {

TEST(SphereGrid, Has_ten_times_four_to_the_level_plus_two_unit_directions) {
  std::size_t expected = 1;
  for (int level = 0; level <= 5; ++level, expected *= 4) {
    const SphereGrid grid(level);
    EXPECT_EQ(grid.size(), 10 * expected + 2);
    for (const Vec3 u : grid.points()) ASSERT_NEAR(norm(u), 1, 1e-6);
  }
}

TEST(SphereGrid, Begins_as_ODAS_numbers_its_directions) {
  const Vec3 level2[]{{0, 0, 1},
                      {.2598919F, .0844440F, .9619383F},
                      {0, .2732666F, .9619383F},
                      {.5F, .1624598F, .8506508F},
                      {.2628656F, .3618034F, .8944272F}};
  const Vec3 level4[]{{0, 0, 1},
                      {.0657576F, .0213659F, .9976069F},
                      {0, .0691416F, .9976069F},
                      {.1312004F, .0426296F, .9904389F},
                      {.0658169F, .0905892F, .9937111F}};
  const SphereGrid two(2);
  const SphereGrid four(4);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT(norm(two.points()[i] - level2[i]), 2e-7F) << i;
    EXPECT_LT(norm(four.points()[i] - level4[i]), 2e-7F) << i;
  }
}

TEST(SphereGrid, Nearest_agrees_with_a_search_over_all_points) {
  const SphereGrid grid(3);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    float least = 10;
    std::size_t nearest = 0;
    for (std::size_t j = 0; j < grid.size(); ++j) {
      const Vec3 d = grid.points()[i] - grid.points()[j];
      if (j != i && dot(d, d) < least) {
        least = dot(d, d);
        nearest = j;
      }
    }
    EXPECT_EQ(grid.nearest(i), nearest) << i;
  }
}

TEST(SphereGrid, Leaves_no_direction_farther_than_its_step) {
  const SphereGrid grid(4);  // neighbours are 3.5 to 4.2 degrees apart
  for (int az = -180; az < 180; az += 7) {
    for (int el = -90; el <= 90; el += 7) {
      const Vec3 u = direction_of(static_cast<float>(az), static_cast<float>(el));
      float best = -1;
      for (const Vec3 p : grid.points()) best = std::max(best, dot(p, u));
      EXPECT_LT(degrees(std::acos(std::min(best, 1.F))), 2.7F) << az << " " << el;
    }
  }
}

TEST(SpherePatch, Holds_the_centre_and_directions_no_farther_than_the_neighbour) {
  const SphereGrid grid(2);
  for (int refined = 0; refined <= 3; ++refined) {
    const SpherePatch patch(refined);
    const std::size_t two = std::size_t{1} << refined;
    EXPECT_EQ(patch.size(), 4 * (two + two * two) + 1);
    std::vector<Vec3> out(patch.size());
    const Vec3 centre = grid.points()[17];
    const Vec3 neighbour = grid.points()[grid.nearest(17)];
    patch.place(centre, neighbour, out);
    EXPECT_NE(std::find_if(out.begin(), out.end(), [&](Vec3 u) { return norm(u - centre) < 1e-6F; }),
              out.end());
    for (const Vec3 u : out) {
      EXPECT_NEAR(norm(u), 1, 1e-6);
      EXPECT_GE(dot(u, centre), dot(neighbour, centre) - 1e-5F);
    }
  }
}

}  // namespace
}  // namespace odas::sphere_grid_test
