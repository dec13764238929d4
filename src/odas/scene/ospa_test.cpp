// SPDX-License-Identifier: MIT
#include "odas/scene/ospa.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace odas::ospa_test {
namespace {

Direction at(double azimuth) { return {std::cos(azimuth * M_PI / 180), std::sin(azimuth * M_PI / 180), 0}; }

/// Ten hops; sources at rest, all speaking.
KnownScene scene_of(const std::vector<double>& azimuths) {
  KnownScene scene;
  scene.hops = 10;
  for (const double azimuth : azimuths) {
    scene.sources.push_back({std::vector<Direction>(10, at(azimuth)), std::vector<std::uint8_t>(10, 1)});
  }
  return scene;
}

std::vector<HeardHop> heard_at(const std::vector<double>& azimuths) {
  std::vector<HeardHop> heard(10);
  for (std::size_t h = 0; h < heard.size(); ++h) {
    heard[h].hop = h;
    for (std::size_t t = 0; t < azimuths.size(); ++t) heard[h].tracks.push_back({t, t + 1, at(azimuths[t])});
  }
  return heard;
}

double ospa(const KnownScene& scene, const std::vector<HeardHop>& heard) {
  return ospa_deg(scene, heard, Measure::azimuth);
}

TEST(Ospa, is_the_mean_error_where_the_number_is_right) {
  EXPECT_NEAR(ospa(scene_of({0, 90}), heard_at({94, -2})), 3, 1e-9);
}

TEST(Ospa, is_the_cut_off_where_nothing_is_heard_or_only_what_is_not_there) {
  EXPECT_NEAR(ospa(scene_of({0, 90}), {}), kOspaCutOff, 1e-9);
  EXPECT_NEAR(ospa(scene_of({}), heard_at({10})), kOspaCutOff, 1e-9);
}

TEST(Ospa, shares_the_cost_of_a_track_too_many_among_all) {
  EXPECT_NEAR(ospa(scene_of({0, 90}), heard_at({0, 90, 180})), kOspaCutOff / 3, 1e-9);
}

TEST(Ospa, of_silence_and_no_track_is_zero) { EXPECT_EQ(ospa(scene_of({}), heard_at({})), 0); }

TEST(Ospa, does_not_blame_a_track_that_waits_at_a_silent_source) {
  KnownScene scene = scene_of({0, 90});
  scene.sources[1].active.assign(10, 0);
  EXPECT_NEAR(ospa(scene, heard_at({0, 95})), 0, 1e-9);
  EXPECT_NEAR(ospa(scene, heard_at({0, 120})), kOspaCutOff / 2, 1e-9);
  // Where the silent one stands beside the speaking one, the track counts as the speaking one's.
  scene.sources[1].direction.assign(10, at(10));
  EXPECT_NEAR(ospa(scene, heard_at({8})), 8, 1e-9);
}

}  // namespace
}  // namespace odas::ospa_test
