// SPDX-License-Identifier: MIT
// What every registered tracker promises.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "support/allocation_counter.hpp"
#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/tracking/tracker.hpp"

namespace odas::tracking_contract_test {
namespace {

using test::angle_deg;

constexpr float kClear = 0.45F;  // E of a source that sounds
constexpr float kNoise = 0.1F;   // and of none

bool same(const std::vector<Track>& a, const std::vector<Track>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Track& x, const Track& y) {
    return x.id == y.id && x.tag == y.tag && x.direction == y.direction && x.activity == y.activity;
  });
}

class TrackingContract : public ::testing::TestWithParam<std::string_view> {
 protected:
  struct Run {
    explicit Run(const SstConfig& config, std::size_t potentials = 4)
        : tracker(make_tracker(config, {0.008, 0.5, potentials})),
          tracks(config.slots()),
          heard(potentials) {}
    /// One hop in which these directions sound.
    const std::vector<Track>& hop(const std::vector<Vec3>& sources) {
      for (std::size_t s = 0; s < heard.size(); ++s) {
        heard[s] = s < sources.size() ? Potential{sources[s], kClear} : Potential{{0, 0, 1}, kNoise};
      }
      tracker->update(heard, tracks);
      return tracks;
    }
    const std::vector<Track>& hops(int count, const std::vector<Vec3>& sources) {
      for (int i = 0; i < count; ++i) hop(sources);
      return tracks;
    }
    [[nodiscard]] const Track* near(Vec3 u) const {
      const auto found = std::find_if(tracks.begin(), tracks.end(), [&](const Track& t) {
        return t.id != 0 && angle_deg(t.direction, u) < 10;
      });
      return found == tracks.end() ? nullptr : &*found;
    }
    std::unique_ptr<Tracker> tracker;
    std::vector<Track> tracks;
    std::vector<Potential> heard;
  };

  [[nodiscard]] static SstConfig config() {
    SstConfig config;
    config.mode = std::string(GetParam());
    config.particle.n_particles = 200;
    return config;
  }
  /// Two talkers with jitter, one of whom walks and pauses now and then.
  static std::vector<Vec3> scene(int hop, std::mt19937& random) {
    std::uniform_real_distribution<float> jitter(-3, 3);
    const Vec3 stands = direction_of(100 + jitter(random), 20 + jitter(random));
    const Vec3 walks =
        direction_of(-60 + 0.03F * static_cast<float>(hop) + jitter(random), 10 + jitter(random));
    if (hop % 100 > 70) return {stands};
    return {walks, stands};
  }
};

TEST_P(TrackingContract, follows_two_talkers_within_their_jitter_in_slots_of_their_own) {
  Run run(config());
  std::mt19937 random(3);
  for (int h = 0; h < 600; ++h) {
    run.hop(scene(h, random));
    if (h < 10) continue;
    const Track* stands = run.near(direction_of(100, 20));
    const Track* walks = run.near(direction_of(-60 + 0.03F * static_cast<float>(h), 10));
    ASSERT_TRUE(stands != nullptr && walks != nullptr) << "hop " << h;
    ASSERT_EQ(stands->id + walks->id, 3U) << "ids 1 and 2 all along, hop " << h;
    for (const Track& t : run.tracks) {
      ASSERT_NEAR(norm(t.direction), t.id != 0 ? 1 : 0, 1e-5);
      ASSERT_TRUE(t.activity >= 0 && t.activity <= 1);
    }
  }
}

TEST_P(TrackingContract, gives_the_same_bits_after_reset_and_in_a_second_one) {
  SstConfig with_memory = config();
  with_memory.memory = 2;
  with_memory.target = {{"door", 0, 0, 1}};
  Run used(with_memory);
  std::mt19937 other(9);
  for (int h = 0; h < 300; ++h) used.hop(scene(3 * h, other));
  const Target window{"window", {0, 1, 0}};
  used.tracker->set_targets({&window, 1});
  used.hops(300, {});
  used.tracker->reset();
  Run fresh(with_memory);
  std::mt19937 first(4);
  std::mt19937 second(4);
  for (int h = 0; h < 600; ++h)
    ASSERT_TRUE(same(used.hop(scene(h, first)), fresh.hop(scene(h, second)))) << h;
}

TEST_P(TrackingContract, potentials_that_are_not_finite_count_as_none) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::max()}) {
    for (const Potential broken : {Potential{{bad, 0, 0}, kClear}, Potential{{0, bad, bad}, bad},
                                   Potential{direction_of(10, 0), bad}, Potential{{bad, bad, bad}, kNoise}}) {
      Run run(config());
      const Vec3 u = direction_of(10, 0);
      run.hops(20, {u});
      ASSERT_NE(run.near(u), nullptr);
      for (int h = 0; h < 20; ++h) {
        std::fill(run.heard.begin(), run.heard.end(), broken);
        run.tracker->update(run.heard, run.tracks);
        for (const Track& t : run.tracks) {
          ASSERT_TRUE(std::isfinite(norm(t.direction)) && std::isfinite(t.activity));
        }
      }
      const Track* after = run.hops(10, {u}).data();
      ASSERT_EQ(after->id, 1U);
      ASSERT_LT(angle_deg(after->direction, u), 3);
      ASSERT_GT(after->activity, 0.9F);
      ASSERT_EQ(std::count_if(run.tracks.begin(), run.tracks.end(), [](auto& t) { return t.id != 0; }), 1);
    }
  }
}

TEST_P(TrackingContract, takes_no_potentials_and_fewer_than_it_was_made_for) {
  Run run(config());
  const Vec3 u = direction_of(10, 0);
  run.hops(10, {u});
  run.tracker->update({}, run.tracks);
  EXPECT_EQ(run.tracks[0].activity, 0);
  const Potential one{u, kClear};
  run.tracker->update({&one, 1}, run.tracks);
  EXPECT_GT(run.tracks[0].activity, 0.9F);
  Run deaf(config(), 0);
  deaf.hop({});
  EXPECT_EQ(deaf.tracks[0].id, 0U);
}

TEST_P(TrackingContract, follows_as_many_sources_as_it_has_slots_up_to_64) {
  for (const std::size_t slots : {1U, 4U, 17U, 64U}) {
    SstConfig many = config();
    many.n_tracks = static_cast<int>(slots);
    // So many directions on one sphere lie close: observations must be sharp to be told apart.
    many.sigma_r2_prob = many.sigma_r2_active = 0.001F;
    Run run(many, 64);
    std::vector<Vec3> sources;
    for (int i = 0; i < 64; ++i) {  // Fibonacci's sphere
      const float z = 1 - (2 * static_cast<float>(i) + 1) / 64;
      const float r = std::sqrt(1 - z * z);
      const float a = 2.3999632F * static_cast<float>(i);
      sources.push_back({r * std::cos(a), r * std::sin(a), z});
    }
    run.hops(40, sources);  // who is beside another takes longer
    ASSERT_EQ(run.tracks.size(), slots);
    EXPECT_TRUE(std::all_of(run.tracks.begin(), run.tracks.end(), [](const Track& t) { return t.id != 0; }))
        << slots;
  }
}

TEST_P(TrackingContract, allocates_nothing_after_construction) {
  SstConfig busy = config();
  busy.n_inactive = {20, 20, 20, 20};
  busy.memory = 1;
  Run run(busy);
  const std::vector<std::vector<Vec3>> talks{
      {direction_of(10, 0)}, {direction_of(100, 0), direction_of(-90, 0)}, {}, {direction_of(12, 0)}};
  const std::vector<Target> targets{{"door", {0, 0, 1}}, {"desk", {0, -1, 0}}};
  const auto before = test::allocations();
  for (int round = 0; round < 5; ++round) {
    for (const auto& sources : talks) {
      run.hops(40, sources);
      run.tracker->set_targets({targets.data(), static_cast<std::size_t>(round % 3)});
    }
  }
  run.tracker->reset();
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(run.tracks.size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(All, TrackingContract, ::testing::ValuesIn(tracker_names()),
                         [](const auto& name) { return std::string(name.param); });

TEST(TrackerRegistry, refuses_a_name_that_is_not_there_and_says_which_are) {
  SstConfig config;
  config.mode = "kalmann";
  try {
    (void)make_tracker(config, {0.008, 1, 4});
    FAIL() << "made a kalmann";
  } catch (const ConfigError& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    EXPECT_EQ(error.faults()[0].path, "sst.mode");
    EXPECT_NE(error.faults()[0].what.find("kalman, particle"), std::string::npos);
  }
}

}  // namespace
}  // namespace odas::tracking_contract_test
