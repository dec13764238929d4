// SPDX-License-Identifier: MIT
#include "odas/tracking/slot_tracker.hpp"

#include <random>
#include <set>

#include "support/allocation_counter.hpp"
#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::slot_tracker_test {
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
    std::vector<Potential> potentials(4, Potential{{0, 0, 1}, kNoise});
    std::transform(sources.begin(), sources.end(), potentials.begin(), [&](Vec3 u) {
      return Potential{u, energy};
    });
    tracker->update(potentials, tracks);
  }
  void set_targets(const std::vector<Target>& targets) { tracker->set_targets(targets); }
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

TEST_F(SlotTrackerTest, Moves_a_target_at_the_next_hop_and_keeps_its_id_and_slot) {
  SstConfig config;
  config.target = {{"door", 1, 0, 0}, {"desk", 0, 1, 0}};
  make(config);
  hop({});
  const std::uint64_t id = tracks[1].id;
  set_targets({{"door", {1, 0, 0}}, {"desk", {0, 0, 5}}});
  hop({{0, 0, 1}});
  EXPECT_EQ(tracks[1].id, id);
  EXPECT_EQ(tracks[1].tag.view(), "desk");
  EXPECT_EQ(tracks[1].direction, (Vec3{0, 0, 1}));
  EXPECT_GT(tracks[1].activity, 0.9F);
}

TEST_F(SlotTrackerTest, Adds_and_removes_targets_while_running) {
  make({});
  set_targets({{"door", {1, 0, 0}}, {"desk", {0, 1, 0}}});
  EXPECT_TRUE(living().empty()) << "from the next hop on";
  hop({});
  ASSERT_EQ(living().size(), 2U);
  set_targets({{"desk", {0, 1, 0}}});
  hop({});
  EXPECT_EQ(tracks[0].id, 0U) << "its slot is free";
  EXPECT_EQ(tracks[1].id, 2U);
  set_targets({{"desk", {0, 1, 0}}, {"door", {1, 0, 0}}});
  hop({});
  EXPECT_EQ(tracks[0].id, 3U) << "a target that comes again is a new one";
  set_targets({});
  hop({});
  EXPECT_TRUE(living().empty());
}

TEST_F(SlotTrackerTest, Follows_the_first_targets_when_there_are_more_than_slots_and_counts_the_rest) {
  SstConfig config;
  config.n_inactive = {250, 250};
  config.target = {{"a", 1, 0, 0}, {"b", 0, 1, 0}, {"c", 0, 0, 1}};
  make(config);
  hop({});
  ASSERT_EQ(living().size(), 2U);
  EXPECT_EQ(tracker->unfollowed_targets(), 1U);
  set_targets({{"a", {1, 0, 0}}, {"c", {0, 0, 1}}, {"", {0, 0, 1}}});
  hop({});
  EXPECT_EQ(tracks[1].tag.view(), "c");
  EXPECT_EQ(tracker->unfollowed_targets(), 1U) << "the one without a tag";
  set_targets({{"a", {1, 0, 0}}});
  hop({});
  EXPECT_EQ(tracker->unfollowed_targets(), 0U);
  tracker->reset();
  hop({});
  EXPECT_EQ(tracks[1].tag.view(), "b") << "those of the configuration again";
  EXPECT_EQ(tracker->unfollowed_targets(), 1U);
}

TEST_F(SlotTrackerTest, Gives_a_target_the_next_slot_that_becomes_free) {
  SstConfig config;
  config.n_inactive = {20};
  make(config);
  for (int i = 0; i < 10; ++i) hop({direction_of(90, 0)});
  set_targets({{"door", {1, 0, 0}}});
  hop({});
  EXPECT_EQ(tracks[0].tag.view(), "dynamic") << "a talker is not cut off";
  EXPECT_EQ(tracker->unfollowed_targets(), 1U);
  for (int i = 0; i < 40; ++i) hop({});
  EXPECT_EQ(tracks[0].tag.view(), "door");
  EXPECT_EQ(tracker->unfollowed_targets(), 0U);
}

TEST_F(SlotTrackerTest, Follows_targets_that_come_in_static_mode) {
  SstConfig config;
  config.add = "static";
  make(config);
  for (int i = 0; i < 20; ++i) hop({direction_of(90, 0)});
  EXPECT_TRUE(living().empty());
  set_targets({{"door", {0, 1, 0}}});
  hop({direction_of(90, 0)});
  ASSERT_EQ(living().size(), 1U);
  EXPECT_GT(tracks[0].activity, 0.9F);
}

TEST_F(SlotTrackerTest, Has_as_many_slots_as_nTracks_says_and_the_last_patience_holds_for_more) {
  SstConfig config;
  config.n_tracks = 3;
  config.n_inactive = {90, 40};
  make(config);
  ASSERT_EQ(tracks.size(), 3U);
  const std::vector<Vec3> all{direction_of(0, 0), direction_of(120, 0), direction_of(-120, 0)};
  for (int i = 0; i < 20; ++i) hop(all);
  ASSERT_EQ(living().size(), 3U);
  for (int i = 0; i < 39; ++i) hop({});
  EXPECT_EQ(living().size(), 3U);
  hop({});
  EXPECT_EQ(living().size(), 0U) << "40 hops hold for three, too";

  config.n_tracks = 1;
  config.n_inactive = {90, 40, 40, 40};
  EXPECT_EQ(config.slots(), 1U) << "nTracks wins";
  config.n_tracks = 0;
  EXPECT_EQ(config.slots(), 4U) << "as in ODAS";
}

class MemoryTest : public SlotTrackerTest {
 protected:
  void make_with_memory(float seconds) {
    SstConfig config;
    config.n_inactive = {20, 20, 20, 20};
    config.memory = seconds;
    make(config);
  }
  void hops(int count, const std::vector<Vec3>& sources) {
    for (int i = 0; i < count; ++i) hop(sources);
  }
  [[nodiscard]] std::uint64_t id_near(Vec3 u) const {
    for (const Track& t : tracks) {
      if (t.id != 0 && angle_deg(t.direction, u) < 5) return t.id;
    }
    return 0;
  }
};

TEST_F(MemoryTest, Two_talkers_who_pause_in_turn_keep_their_ids) {
  make_with_memory(2);
  const Vec3 a = direction_of(-60, 0);
  const Vec3 b = direction_of(60, 0);
  hops(20, {a});
  hops(20, {b, a});
  ASSERT_EQ(id_near(a), 1U);
  ASSERT_EQ(id_near(b), 2U);
  for (int turn = 0; turn < 3; ++turn) {
    hops(100, {b});
    EXPECT_EQ(id_near(a), 0U) << "it has gone";
    hops(100, {a});
    EXPECT_EQ(id_near(b), 0U);
    EXPECT_EQ(id_near(a), 1U);
    hops(20, {b, a});
    EXPECT_EQ(id_near(b), 2U);
    EXPECT_EQ(id_near(a), 1U);
  }
}

TEST_F(MemoryTest, One_who_comes_back_too_late_or_elsewhere_is_a_new_one) {
  make_with_memory(1);  // 125 hops
  hops(20, {direction_of(0, 0)});
  hops(60, {});
  hops(10, {direction_of(20, 0)});
  EXPECT_EQ(id_near(direction_of(20, 0)), 2U) << "elsewhere";
  hops(20 + 200, {});
  hops(10, {direction_of(0, 0)});
  EXPECT_EQ(id_near(direction_of(0, 0)), 3U) << "too late";
}

TEST_F(MemoryTest, Two_who_come_back_at_once_near_each_other_do_not_swap) {
  make_with_memory(2);
  const Vec3 a = direction_of(0, 0);
  const Vec3 b = direction_of(25, 0);
  hops(20, {a, b});
  ASSERT_EQ(id_near(a), 1U);
  ASSERT_EQ(id_near(b), 2U);
  hops(60, {});
  // Both are within reach of b's place, and the first potential, which gets the first slot, is a's.
  hops(10, {direction_of(11, 0), direction_of(26, 0)});
  EXPECT_EQ(id_near(direction_of(26, 0)), 2U) << "the nearest";
  EXPECT_EQ(id_near(direction_of(11, 0)), 1U);
}

TEST_F(MemoryTest, One_who_comes_back_has_his_old_slot_where_it_is_free_and_another_where_not) {
  make_with_memory(2);
  const Vec3 a = direction_of(-60, 0);
  const Vec3 b = direction_of(60, 0);
  const Vec3 c = direction_of(160, 0);
  hops(20, {a, b});
  ASSERT_LT(angle_deg(tracks[1].direction, b), 5);
  const std::uint64_t id = tracks[1].id;
  hops(60, {});
  ASSERT_EQ(tracks[0].id + tracks[1].id, 0U);
  hops(10, {b});
  EXPECT_EQ(tracks[1].id, id) << "slot 0 is free, too, and comes first";
  EXPECT_LT(angle_deg(tracks[1].direction, b), 5);
  hops(60, {});
  hops(20, {c, a});  // c gets slot 0; a, who had that, another one
  EXPECT_EQ(tracks[0].id, 1U) << "a is known, and nobody was seen there yet";
  hops(20, {a, c, direction_of(-150, 0)});
  hops(20, {b, a, c, direction_of(-150, 0)});
  EXPECT_EQ(id_near(b), id);
  std::size_t seen = 0;
  for (const Track& t : tracks) seen += t.id != 0 ? 1U : 0U;
  EXPECT_EQ(seen, 4U);
}

TEST_F(MemoryTest, Without_it_ids_are_never_used_again) {
  make_with_memory(0);
  for (std::uint64_t i = 1; i < 5; ++i) {
    hops(20, {direction_of(0, 0)});
    EXPECT_EQ(id_near(direction_of(0, 0)), i);
    hops(30, {});
  }
}

}  // namespace
}  // namespace odas::slot_tracker_test
