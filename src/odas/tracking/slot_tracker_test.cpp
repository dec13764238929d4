// SPDX-License-Identifier: MIT
#include "odas/tracking/slot_tracker.hpp"

#include <random>
#include <set>

#include "support/allocation_counter.hpp"
#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

using test::angle_deg;

constexpr float kClear = 0.45F;  // E of a source that sounds
constexpr float kNoise = 0.1F;   // and of none

class SlotTrackerTest : public ::testing::Test {
 protected:
  void make(const SstConfig& config) {
    tracks.assign(config.slots(), Track{});
    tracker = make_tracker(config, {0.008, 0.5, 4});
  }
  /// One hop in which these directions sound.
  void hop(const std::vector<Vec3>& sources, float energy = kClear) {
    std::vector<Potential> potentials(4);
    for (std::size_t s = 0; s < 4; ++s) {
      potentials[s] = s < sources.size() ? Potential{sources[s], energy} : Potential{{0, 0, 1}, kNoise};
    }
    tracker->update(potentials, tracks);
  }
  [[nodiscard]] std::vector<Track> living() const {
    std::vector<Track> list;
    for (const Track& t : tracks) {
      if (t.id != 0) list.push_back(t);
    }
    return list;
  }
  std::unique_ptr<Tracker> tracker;
  std::vector<Track> tracks;
};

TEST_F(SlotTrackerTest, Confirms_a_source_after_its_probation) {
  make({});
  const Vec3 u = direction_of(40, 10);
  for (int i = 0; i < 5; ++i) {
    hop({u});
    EXPECT_TRUE(living().empty()) << "hop " << i;
  }
  hop({u});  // born in the first hop, five hops on probation
  ASSERT_EQ(living().size(), 1U);
  EXPECT_EQ(living()[0].id, 1U);
  EXPECT_EQ(living()[0].tag.view(), "dynamic");
  EXPECT_LT(angle_deg(living()[0].direction, u), 1);
  EXPECT_GT(living()[0].activity, 0.9F);
}

TEST_F(SlotTrackerTest, Forgets_a_source_after_its_patience_and_never_uses_an_id_again) {
  SstConfig config;
  config.n_inactive = {50, 50, 50, 50};
  make(config);
  for (int i = 0; i < 20; ++i) hop({direction_of(40, 10)});
  ASSERT_EQ(living().size(), 1U);
  int hops = 0;
  while (!living().empty() && hops < 1000) {
    hop({});
    ++hops;
  }
  EXPECT_EQ(hops, 50);
  for (int i = 0; i < 20; ++i) hop({direction_of(40, 10)});
  ASSERT_EQ(living().size(), 1U);
  EXPECT_EQ(living()[0].id, 2U);
}

TEST_F(SlotTrackerTest, Keeps_a_track_in_its_slot_while_others_come_and_go) {
  SstConfig config;
  config.n_inactive = {30, 30, 30, 30};
  make(config);
  const Vec3 a = direction_of(-60, 0);
  const Vec3 b = direction_of(60, 0);
  for (int i = 0; i < 10; ++i) hop({a});
  for (int i = 0; i < 20; ++i) hop({a, b});
  ASSERT_EQ(living().size(), 2U);
  const std::uint64_t id_of_b = tracks[1].id;
  EXPECT_NE(id_of_b, 0U);
  for (int i = 0; i < 100; ++i) hop({b});
  EXPECT_EQ(tracks[0].id, 0U) << "a has gone";
  EXPECT_EQ(tracks[1].id, id_of_b) << "b stays where it was";
  for (int i = 0; i < 20; ++i) hop({a, b});
  EXPECT_NE(tracks[0].id, 0U);
  EXPECT_EQ(tracks[1].id, id_of_b);
}

// ODAS fault B15: one birth a hop, the last potential won, and ids skipped.
TEST_F(SlotTrackerTest, Bears_two_sources_in_one_hop_with_ids_that_do_not_skip) {
  make({});
  const Vec3 a = direction_of(-60, 0);
  const Vec3 b = direction_of(60, 0);
  for (int i = 0; i < 6; ++i) hop({a, b});
  ASSERT_EQ(living().size(), 2U);
  EXPECT_EQ(living()[0].id, 1U);
  EXPECT_EQ(living()[1].id, 2U);
  EXPECT_LT(angle_deg(living()[0].direction, a), 1);
  EXPECT_LT(angle_deg(living()[1].direction, b), 1);
}

TEST_F(SlotTrackerTest, Bears_one_track_of_two_potentials_side_by_side) {
  make({});
  for (int i = 0; i < 10; ++i) hop({direction_of(40, 0), direction_of(41, 0)});
  EXPECT_EQ(living().size(), 1U);
}

// ODAS fault B15: positions lay inside the sphere.
TEST_F(SlotTrackerTest, Gives_directions_of_length_one) {
  make({});
  std::mt19937 random(2);
  std::normal_distribution<float> jitter(0, 5);
  for (int i = 0; i < 300; ++i) {
    hop({direction_of(0.5F * static_cast<float>(i) + jitter(random), jitter(random))});
    for (const Track& t : living()) ASSERT_NEAR(norm(t.direction), 1, 1e-5);
  }
}

TEST_F(SlotTrackerTest, Follows_no_more_sources_than_it_has_slots) {
  SstConfig config;
  config.n_inactive = {250, 250};
  make(config);
  for (int i = 0; i < 30; ++i)
    hop({direction_of(0, 0), direction_of(90, 0), direction_of(180, 0), direction_of(-90, 0)});
  EXPECT_EQ(living().size(), 2U);
}

TEST_F(SlotTrackerTest, Ends_a_probation_that_was_not_active_enough) {
  make({});
  hop({direction_of(40, 10)});
  for (int i = 0; i < 100; ++i) hop({});
  EXPECT_TRUE(living().empty());
  for (int i = 0; i < 6; ++i) hop({direction_of(40, 10)});
  EXPECT_EQ(living().size(), 1U) << "its slot is free again";
}

TEST_F(SlotTrackerTest, Holds_targets_where_they_are_from_the_first_hop_on) {
  SstConfig config;
  config.add = "static";
  config.target = {{"door", 1, 0, 0}, {"desk", 0, 2, 0}};
  make(config);
  hop({direction_of(90, 0)});
  ASSERT_EQ(living().size(), 2U);
  EXPECT_EQ(tracks[0].tag.view(), "door");
  EXPECT_EQ(tracks[1].direction, (Vec3{0, 1, 0}));
  EXPECT_LT(tracks[0].activity, 0.1F);
  EXPECT_GT(tracks[1].activity, 0.9F);
  for (int i = 0; i < 300; ++i) hop({direction_of(-45, 0)});
  EXPECT_EQ(living().size(), 2U) << "targets do not die, and static mode bears no others";
}

TEST_F(SlotTrackerTest, Lets_new_sources_come_beside_its_targets) {
  SstConfig config;
  config.target = {{"door", 1, 0, 0}};
  make(config);
  for (int i = 0; i < 10; ++i) hop({direction_of(90, 0)});
  ASSERT_EQ(living().size(), 2U);
  EXPECT_EQ(living()[1].tag.view(), "dynamic");
}

TEST_F(SlotTrackerTest, Is_as_new_after_reset_and_allocates_nothing) {
  make({});
  const auto walk = [&] {
    std::vector<Track> seen;
    for (int i = 0; i < 50; ++i) {
      hop({direction_of(static_cast<float>(i), 0)});
      for (const Track& t : tracks) seen.push_back(t);
    }
    return seen;
  };
  const auto first = walk();
  tracker->reset();
  const auto second = walk();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].id, second[i].id);
    EXPECT_EQ(first[i].direction, second[i].direction);
    EXPECT_EQ(first[i].activity, second[i].activity);
  }
  const std::vector<Potential> potentials(4, Potential{direction_of(120, 0), kClear});
  const auto before = test::allocations();
  for (int i = 0; i < 20; ++i) tracker->update(potentials, tracks);
  EXPECT_EQ(test::allocations(), before);
}

TEST(TrackerRegistry, Refuses_a_name_that_it_does_not_know) {
  SstConfig config;
  config.mode = "kalmann";
  EXPECT_THROW(static_cast<void>(make_tracker(config, {0.008, 1, 4})), ConfigError);
}

}  // namespace
}  // namespace odas
