// SPDX-License-Identifier: MIT
#include "odas/scene/track_score.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace odas::track_score_test {
namespace {

Direction at(double azimuth, double elevation = 0) {
  const double a = azimuth * M_PI / 180;
  const double e = elevation * M_PI / 180;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

constexpr std::size_t kHops = 750;  // 6 s of 8 ms: a tenth of a minute

/// Source 0 at 0 degrees speaks in hops 100..299, source 1 at 90 degrees in 200..699.
KnownScene two_talkers() {
  KnownScene scene;
  scene.hops = kHops;
  scene.sources.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    scene.sources[k].direction.assign(kHops, at(k == 0 ? 0 : 90));
    scene.sources[k].active.assign(kHops, 0);
  }
  for (std::size_t h = 100; h < 300; ++h) scene.sources[0].active[h] = 1;
  for (std::size_t h = 200; h < 700; ++h) scene.sources[1].active[h] = 1;
  return scene;
}

struct Stay {
  std::uint64_t id;
  std::size_t slot, from, to;
  Direction direction;
};

std::vector<HeardHop> heard_of(const std::vector<Stay>& stays) {
  std::vector<HeardHop> heard(kHops);
  for (std::size_t h = 0; h < kHops; ++h) {
    heard[h].hop = h;
    for (const Stay& stay : stays) {
      if (h >= stay.from && h < stay.to) heard[h].tracks.push_back({stay.slot, stay.id, stay.direction});
    }
  }
  return heard;
}

TEST(TrackScore, agrees_with_figures_computed_by_hand) {
  // Source 0: followed from hop 125 on, 3 degrees off, through its silence. Source 1: 5 degrees off, by id 2
  // until 450, then by id 3. Id 9: 40 hops beside source 1, and 50 hops where nobody is.
  const auto heard = heard_of({{1, 0, 125, 350, at(3)},
                               {2, 1, 200, 450, at(95)},
                               {3, 2, 450, 700, at(85)},
                               {9, 3, 300, 340, at(100)},
                               {9, 3, 340, 390, at(-120)}});
  const auto score = score_tracks(two_talkers(), heard, Measure::azimuth);
  EXPECT_NEAR(*score.recall, (175 + 500) / 700.0, 1e-12);
  EXPECT_NEAR(*score.error_deg, (175 * 3 + 500 * 5) / 675.0, 1e-9);
  EXPECT_NEAR(score.false_s_per_min, 50 * 0.008 / 0.1, 1e-9);
  EXPECT_NEAR(*score.duplicates, 40.0 / kHops, 1e-12);
  EXPECT_NEAR(*score.switches_per_min, 1 / 0.1 / 2, 1e-9);
  EXPECT_NEAR(*score.onset_s, (25 * 0.008 + 0) / 2, 1e-12);
  EXPECT_EQ(score.followed[0][124].id, 0U);
  EXPECT_EQ(score.followed[0][349].id, 1U);  // in its silence too
  EXPECT_EQ(score.followed[1][449].slot, 1U);
  EXPECT_EQ(score.followed[1][450].slot, 2U);
}

TEST(TrackScore, tells_who_changed_ids_in_a_crossing_from_whose_pairs_were_undecided_in_it) {
  // Source 0 walks past source 1, which stands at 90 degrees, from 45 to 135.
  auto scene = two_talkers();
  for (std::size_t h = 0; h < kHops; ++h) {
    scene.sources[0].direction[h] = at(45 + 90 * static_cast<double>(h) / kHops);
    scene.sources[0].active[h] = scene.sources[1].active[h] = 1;
  }
  const auto crossing = [&](bool swapped) {
    auto heard = heard_of({});
    for (std::size_t h = 0; h < kHops; ++h) {
      const bool passing = h > 330 && h < 370;
      const bool others = h >= 370 ? swapped : passing;  // for a moment each is nearer to the other's
      heard[h].tracks.push_back({0, others ? 2U : 1U, scene.sources[0].direction[h]});
      heard[h].tracks.push_back({1, others ? 1U : 2U, scene.sources[1].direction[h]});
    }
    return score_tracks(scene, heard, Measure::azimuth);
  };
  EXPECT_NEAR(*crossing(false).switches_per_min, 2 / 0.1, 1e-9);
  EXPECT_EQ(*crossing(false).switches_apart_per_min, 0);
  EXPECT_NEAR(*crossing(true).switches_apart_per_min, 1 / 0.1, 1e-9);
}

TEST(TrackScore, tells_elevation_only_by_angle) {
  const auto heard = heard_of({{1, 0, 0, kHops, at(0, 30)}});
  EXPECT_NEAR(*score_tracks(two_talkers(), heard, Measure::azimuth).recall, 200 / 700.0, 1e-12);
  const auto by_angle = score_tracks(two_talkers(), heard, Measure::angle);
  EXPECT_EQ(*by_angle.recall, 0);
  EXPECT_FALSE(by_angle.error_deg.has_value());
  EXPECT_EQ(*by_angle.onset_s, kNeverSeconds);
}

TEST(TrackScore, gives_one_track_to_one_source) {
  const auto heard = heard_of({{1, 0, 0, kHops, at(0)}});
  auto scene = two_talkers();
  scene.sources[1].direction.assign(kHops, at(5));
  const auto score = score_tracks(scene, heard, Measure::azimuth);
  EXPECT_NEAR(*score.recall, 200 / 700.0, 1e-12);
  EXPECT_EQ(score.followed[1][250].id, 0U);
}

TEST(TrackScore, of_noise_alone_counts_every_track_as_false) {
  KnownScene nobody;
  nobody.hops = kHops;
  const auto score = score_tracks(nobody, heard_of({{1, 0, 0, 100, at(0)}}), Measure::angle);
  EXPECT_NEAR(score.false_s_per_min, 100 * 0.008 / 0.1, 1e-9);
  EXPECT_FALSE(score.recall.has_value());
}

TEST(TrackScore, does_not_look_beyond_the_scene) {
  auto heard = heard_of({});
  heard[0].hop = kHops;
  heard[0].tracks.push_back({0, 1, at(0)});
  EXPECT_EQ(score_tracks(two_talkers(), heard, Measure::angle).false_s_per_min, 0);
}

TEST(PotentialScore, is_of_hops_in_which_somebody_speaks_against_the_nearest_who_does) {
  std::vector<HeardPotential> heard;
  heard.push_back({50, at(180)});    // nobody speaks
  heard.push_back({150, at(4)});     // source 0: 4 degrees
  heard.push_back({250, at(84)});    // source 1: 6
  heard.push_back({260, at(-120)});  // 120
  heard.push_back({400, at(0)});     // source 0 is silent: 90
  const auto score = score_potentials(two_talkers(), heard, Measure::angle);
  EXPECT_NEAR(*score.median_deg, (6 + 90) / 2.0, 1e-9);
  EXPECT_NEAR(*score.hits, 0.5, 1e-12);
}

TEST(Median, is_the_middle_or_the_mean_of_the_middle_two) {
  EXPECT_EQ(*median({3, 1, 2}), 2);
  EXPECT_EQ(*median({4, 1, 2, 3}), 2.5);
  EXPECT_FALSE(median({}).has_value());
}

}  // namespace
}  // namespace odas::track_score_test
