// SPDX-License-Identifier: MIT
#include "odas/tracking/bernoulli.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace odas::bernoulli_test {
namespace {

constexpr double kHop = 0.008;

struct Said {
  float azimuth, elevation, evidence;
};

/// A tracker that hears potentials which tell their evidence, as of a small flat array.
struct Heard {
  explicit Heard(float memory = 0) {
    SstConfig config;
    config.n_tracks = 4;
    config.n_inactive = {500};
    config.memory = memory;
    tracker = std::make_unique<BernoulliTracker>(config, TrackerContext{kHop, 0.5, 4});
    tracks.resize(4);
  }
  void hop(const std::vector<Said>& said) {
    std::normal_distribution<float> jitter(0, 1);
    std::vector<Potential> potentials;
    for (const Said& s : said) {
      const Vec3 u = direction_of(s.azimuth + 2 * jitter(random), s.elevation + 8 * jitter(random));
      potentials.push_back({u, 0, s.evidence, {0.0012F, 0.02F, 0}});
    }
    tracker->update(potentials, tracks);
  }
  void hops(int count, const std::vector<Said>& said) {
    for (int h = 0; h < count; ++h) hop(said);
  }
  [[nodiscard]] std::ptrdiff_t living() const {
    return std::count_if(tracks.begin(), tracks.end(), [](const Track& t) { return t.id != 0; });
  }
  /// Of the track near this azimuth; 0: there is none.
  [[nodiscard]] std::uint64_t id_at(float azimuth) const {
    for (const Track& t : tracks) {
      if (t.id != 0 && std::abs(std::remainder(azimuth_deg(t.direction) - azimuth, 360)) < 8) return t.id;
    }
    return 0;
  }
  std::mt19937 random{7};
  std::unique_ptr<BernoulliTracker> tracker;
  std::vector<Track> tracks;
};

TEST(Bernoulli, confirms_a_clear_voice_within_50_ms_and_a_faint_one_within_half_a_second) {
  Heard clear;
  clear.hops(6, {{30, 20, 5}});
  EXPECT_EQ(clear.id_at(30), 1U);
  Heard faint;
  faint.hops(6, {{30, 20, 1.5F}});
  EXPECT_EQ(faint.living(), 0);
  faint.hops(56, {{30, 20, 1.5F}});
  EXPECT_EQ(faint.id_at(30), 1U);
}

TEST(Bernoulli, makes_no_track_of_noise_whose_directions_stay_and_whose_evidence_is_against_it) {
  Heard run;
  for (int h = 0; h < 2000; ++h) {
    run.hop({{50, 20, h % 50 == 0 ? 1.F : -1.F}, {-120, 0, -3}});
    ASSERT_EQ(run.living(), 0) << h;
  }
}

TEST(Bernoulli, takes_two_elevations_of_one_azimuth_for_one_talker) {
  Heard run;
  run.hops(500, {{30, 15, 5}, {30, 40, 4}});
  EXPECT_EQ(run.living(), 1);
}

TEST(Bernoulli, makes_no_track_of_what_stays_of_a_stronger_talker_beside_it) {
  Heard run;
  run.hops(500, {{30, 15, 6}, {52, 10, 2.5F}});
  EXPECT_EQ(run.living(), 1);
  EXPECT_NE(run.id_at(30), 0U);
}

TEST(Bernoulli, believes_later_in_who_is_never_the_loudest) {
  Heard led;
  led.hops(10, {{30, 20, 6}, {150, 20, 5.7F}});
  EXPECT_NE(led.id_at(150), 0U);
  Heard behind;
  behind.hops(10, {{30, 20, 6}, {150, 20, 4}});
  EXPECT_EQ(behind.id_at(150), 0U);
  behind.hops(20, {{30, 20, 6}, {150, 20, 4}});
  EXPECT_NE(behind.id_at(150), 0U);
}

TEST(Bernoulli, keeps_who_was_heard_well_through_a_pause_and_knows_who_comes_back_later) {
  Heard run(10);
  run.hops(300, {{30, 20, 5}});
  run.hops(300, {});  // 2.4 s
  EXPECT_EQ(run.id_at(30), 1U);
  run.hops(500, {});
  EXPECT_EQ(run.living(), 0);
  run.hops(20, {{30, 20, 5}});
  EXPECT_EQ(run.id_at(30), 1U);
}

TEST(Bernoulli, drops_sooner_what_was_heard_little) {
  Heard run;
  run.hops(7, {{30, 20, 5}});
  ASSERT_EQ(run.living(), 1);
  run.hops(200, {});
  EXPECT_EQ(run.living(), 0);
}

TEST(Bernoulli, keeps_the_identities_of_two_who_cross) {
  Heard run;
  for (int h = 0; h < 1000; ++h) {  // 12 degrees/s each, for 8 s
    const auto turn = 0.096F * static_cast<float>(h);
    const float first = turn;
    const float second = 96 - turn;
    // Near each other only one is found, now this one, now that one.
    if (std::abs(first - second) > 18) {
      run.hop({{first, 20, 5}, {second, 20, 4.5F}});
    } else {
      run.hop({{(h / 12) % 2 == 0 ? first : second, 20, 5}});
    }
    if (h == 100) {
      ASSERT_EQ(run.id_at(first), 1U);
      ASSERT_EQ(run.id_at(second), 2U);
    }
  }
  EXPECT_EQ(run.id_at(96), 1U);
  EXPECT_EQ(run.id_at(0), 2U);
}

TEST(Bernoulli, forgets_two_who_met_and_fell_silent) {
  Heard run;
  for (int h = 0; h < 480; ++h) {
    const auto turn = 0.096F * static_cast<float>(h);
    run.hop({{turn, 20, 5}, {96 - turn, 20, 4.5F}});
  }
  ASSERT_EQ(run.living(), 2);
  run.hops(520, {});  // longer than the longest patience, although each hides the other
  EXPECT_EQ(run.living(), 0);
}

TEST(Bernoulli, knows_who_walked_on_in_a_pause_faster_than_before) {
  Heard run;
  for (int h = 0; h < 375; ++h) run.hop({{-60 + 12 * static_cast<float>(h * kHop), 20, 5}});
  const std::uint64_t id = run.id_at(-24);
  ASSERT_NE(id, 0U);
  run.hops(75, {});
  run.hops(12, {{0, 20, 5}});  // as soon as anybody, though his track is beside
  EXPECT_EQ(run.id_at(0), id);
  EXPECT_EQ(run.living(), 1);
}

TEST(Bernoulli, tells_that_azimuth_is_surer_than_elevation) {
  Heard run;
  run.hops(100, {{30, 20, 5}});
  ASSERT_EQ(run.tracks[0].id, 1U);
  const auto covariance = run.tracks[0].covariance;
  EXPECT_GT(covariance.east, 0);
  EXPECT_GT(covariance.north, 2 * covariance.east);
}

/// A track after 4 s of a sound whose ln E has this deviation, over a tenth of a second each time.
std::ptrdiff_t living_after(float deviation) {
  Heard run;
  std::normal_distribution<float> swell(0, deviation);
  float loudness = 0;
  for (int h = 0; h < 500; ++h) {
    if (h % 12 == 0) loudness = swell(run.random);
    const Potential potential{direction_of(30, 20), 0.004F * std::exp(loudness), 4, {0.0012F, 0.02F, 0}};
    run.tracker->update(std::vector<Potential>{potential}, run.tracks);
    if (h == 200) { EXPECT_EQ(run.living(), 1); }
  }
  return run.living();
}

TEST(Bernoulli, follows_who_swells_and_fades_and_after_two_seconds_no_more_what_does_not) {
  EXPECT_EQ(living_after(1), 1);
  EXPECT_EQ(living_after(0.3F), 0);
}

TEST(Bernoulli, takes_the_middle_of_heights_of_which_the_high_ones_look_surer) {
  Heard run;
  for (int h = 0; h < 600; ++h) {
    const bool high = h / 6 % 2 == 0;
    const Vec3 u = direction_of(30, high ? 35 : 5);
    run.tracker->update(std::vector<Potential>{{u, 0, 5, {0.0012F, high ? 0.005F : 0.08F, 0}}}, run.tracks);
  }
  ASSERT_EQ(run.living(), 1);
  EXPECT_NEAR(elevation_deg(run.tracks[0].direction), 20, 4);
}

}  // namespace
}  // namespace odas::bernoulli_test
