// SPDX-License-Identifier: MIT
#include "odas/pipeline/muting.hpp"

#include <vector>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::muting_test {
namespace {

Muting at_azimuth_90() {
  Muting muting;
  muting.set(std::vector<Target>{{"window", {0, 5, 0}}});
  return muting;
}

TEST(Muting, takes_the_energy_of_what_is_near_and_of_nothing_else) {
  std::vector<Potential> potentials{{direction_of(76, 0), 0.5F},
                                    {direction_of(90, 14), 0.5F},
                                    {direction_of(74, 0), 0.5F},
                                    {direction_of(-90, 0), 0.5F}};
  at_azimuth_90().hush(potentials);
  EXPECT_EQ(potentials[0].energy, 0);
  EXPECT_EQ(potentials[1].energy, 0);
  EXPECT_EQ(potentials[2].energy, 0.5F);
  EXPECT_EQ(potentials[3].energy, 0.5F);
}

TEST(Muting, hides_tracks_but_no_targets) {
  std::vector<Track> tracks{{.id = 1, .tag = "dynamic", .direction = {0, 1, 0}},
                            {.id = 2, .tag = "door", .direction = {0, 1, 0}},
                            {.id = 3, .tag = "dynamic", .direction = {1, 0, 0}}};
  at_azimuth_90().hush(tracks);
  EXPECT_EQ(tracks[0].id, 0U);
  EXPECT_EQ(tracks[1].id, 2U);
  EXPECT_EQ(tracks[2].id, 3U);
}

TEST(Muting, does_nothing_unless_it_is_told_to) {
  std::vector<Potential> potentials{{{0, 0, 1}, 1}};
  Muting().hush(potentials);
  EXPECT_EQ(potentials[0].energy, 1);
}

}  // namespace
}  // namespace odas::muting_test
