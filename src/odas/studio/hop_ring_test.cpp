// SPDX-License-Identifier: MIT
#include "odas/studio/hop_ring.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::hop_ring_test {
namespace {

StreamInfo some_run(std::uint64_t id) {
  StreamInfo info;
  info.run = id;
  info.hop_size = 64;
  info.mics.resize(2);
  return info;
}

HopResult hop_at(const test::HopOfHand& hop, HopIndex time) { return hop.result(time); }

test::HopOfHand some_hop() {
  test::HopOfHand hop;
  hop.tracks.resize(2);
  hop.tracks[1].id = 9;
  hop.separated = hop.postfiltered = Grid<float>(2, 64);
  return hop;
}

TEST(HopRing, gives_each_reader_what_came_since_he_last_asked) {
  HopRing ring;
  ring.begin(some_run(5));
  ring.demand({.hops = true});
  const test::HopOfHand hop = some_hop();
  for (HopIndex t = 1; t <= 10; ++t) ring.hop(hop_at(hop, t));
  const HopRing::Reading all = ring.read(0, 100);
  EXPECT_EQ(all.run, 5U);
  EXPECT_EQ(all.lost, 0U);
  ASSERT_EQ(all.frames.size(), 10U);
  EXPECT_EQ(all.frames[3]->time, 4U);
  EXPECT_EQ(all.frames[3]->ids, (std::vector<std::uint64_t>{0, 9}));
  EXPECT_EQ(ring.read(7, 2).frames.size(), 2U);
  EXPECT_EQ(ring.read(ring.end_number(), 9).frames.size(), 0U);
}

TEST(HopRing, encodes_only_what_somebody_wants) {
  HopRing ring;
  ring.begin(some_run(1));
  const test::HopOfHand hop = some_hop();
  ring.hop(hop_at(hop, 1));
  HopRing::Demand demand;
  demand.bare = true;
  demand.audio[0] = true;
  ring.demand(demand);
  ring.hop(hop_at(hop, 2));
  const auto frames = ring.read(0, 9).frames;
  EXPECT_TRUE(frames[0]->full.empty() && frames[0]->bare.empty() && frames[0]->pcm[0].empty());
  EXPECT_TRUE(frames[1]->full.empty());
  EXPECT_FALSE(frames[1]->bare.empty());
  EXPECT_EQ(frames[1]->pcm[0].size(), 2U * 64U);
  EXPECT_TRUE(frames[1]->pcm[1].empty());
}

TEST(HopRing, is_bounded_and_says_what_a_reader_has_lost) {
  HopRing ring;
  StreamInfo info = some_run(1);
  info.hop_size = 1U << 16;
  ring.begin(info);
  HopRing::Demand demand;
  demand.audio[0] = true;
  ring.demand(demand);
  test::HopOfHand hop = some_hop();
  hop.separated = Grid<float>(2, info.hop_size);  // 256 KiB encoded
  for (HopIndex t = 1; t <= 100; ++t) ring.hop(hop_at(hop, t));
  const HopRing::Reading all = ring.read(0, 1000);
  EXPECT_LE(all.frames.size() * info.hop_size * 4, HopRing::kRoom);
  EXPECT_GT(all.frames.size(), 20U);
  EXPECT_EQ(all.lost + all.frames.size(), 100U);
}

TEST(HopRing, holds_sound_at_full_scale_and_takes_no_numbers_for_silence) {
  HopRing ring;
  ring.begin(some_run(1));
  HopRing::Demand demand;
  demand.audio[0] = true;
  ring.demand(demand);
  test::HopOfHand hop = some_hop();
  hop.separated[0][0] = 2;
  hop.separated[0][1] = -2;
  hop.separated[0][2] = std::numeric_limits<float>::quiet_NaN();
  ring.hop(hop_at(hop, 1));
  const auto pcm = ring.read(0, 1).frames[0]->pcm[0];
  EXPECT_EQ(pcm[0], 32767);
  EXPECT_EQ(pcm[1], -32768);
  EXPECT_EQ(pcm[2], 0);
}

TEST(HopRing, forgets_the_hops_of_a_run_when_another_begins) {
  HopRing ring;
  ring.begin(some_run(1));
  const test::HopOfHand hop = some_hop();
  for (HopIndex t = 1; t <= 5; ++t) ring.hop(hop_at(hop, t));
  ring.begin(some_run(2));
  EXPECT_EQ(ring.run_id(), 2U);
  EXPECT_EQ(ring.read(0, 9).frames.size(), 0U);
  ring.hop(hop_at(hop, 1));
  const HopRing::Reading all = ring.read(0, 9);
  EXPECT_EQ(all.frames.size(), 1U);
  EXPECT_EQ(all.lost, 0U) << "hops of another run are none that he lost";
}

}  // namespace
}  // namespace odas::hop_ring_test
