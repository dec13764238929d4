// SPDX-License-Identifier: MIT
#include "odas/studio/hop_joiner.hpp"

#include "support/hop_maker.hpp"
#include "support/kept_hops.hpp"
#include <gtest/gtest.h>

namespace odas::hop_joiner_test {
namespace {

using namespace std::chrono_literals;

/// What an ODAS would send: in each slot the tone of its id.
class HopJoinerTest : public testing::Test {
 protected:
  void make(HopJoiner::Config config = {}) {
    config.channels = 2;
    joiner.emplace(config, kept,
                   [this](const std::string&, const std::string& text) { said.push_back(text); });
  }
  void begin_all() {
    joiner->begin(StreamKind::tracks, now);
    joiner->begin(AudioStream::separated, now);
  }
  /// Of the next hop; which parts are sent.
  void play(int count, const std::vector<std::uint64_t>& ids, bool tracks = true, bool sound = true) {
    for (int i = 0; i < count; ++i) {
      const HopResult hop = maker.next(ids);
      now += 8ms;
      if (tracks) {
        StreamRecord record;
        record.time = hop.time;
        record.tracks.assign(hop.tracks.begin(), hop.tracks.end());
        joiner->add(record, now);
      }
      if (sound) joiner->add(AudioStream::separated, hop.separated);
      joiner->give(now);
    }
  }
  /// Hops with sound; each sample of it is that of the id of its row, or it fails.
  std::size_t sounding() {
    std::size_t count = 0;
    for (const auto& hop : kept.hops()) {
      if (hop.separated.empty()) continue;
      ++count;
      for (std::size_t slot = 0; slot < hop.tracks.size(); ++slot) {
        for (std::size_t i = 0; i < hop.separated[slot].size(); ++i) {
          const std::uint64_t id = hop.tracks[slot].id;
          const float expected = id == 0 ? 0 : test::tone_of(id, (hop.time - 1) * 128 + i);
          if (std::abs(hop.separated[slot][i] - expected) > 1e-6F) {
            ADD_FAILURE() << "hop " << hop.time << ", slot " << slot << ": not the voice of " << id;
            return count;
          }
        }
      }
    }
    return count;
  }
  bool is_said(const std::string& part) {
    return std::any_of(said.begin(), said.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
  }

  test::HopMaker maker;
  test::KeptHops kept;
  std::vector<std::string> said;
  HopJoiner::Clock::time_point now = HopJoiner::Clock::now();
  std::optional<HopJoiner> joiner;
};

TEST_F(HopJoinerTest, gives_each_voice_to_its_track_to_the_sample) {
  make();
  begin_all();
  for (std::uint64_t i = 0; i < 60; ++i) play(5, {i % 7 == 0 ? 0 : 1 + i / 7, 100 + i});
  EXPECT_EQ(kept.count(), 300U);
  EXPECT_EQ(sounding(), 300U);
  EXPECT_TRUE(said.empty());
  EXPECT_EQ(kept.infos().at(0).kind, StreamInfo::Kind::odas);
  EXPECT_EQ(kept.infos().at(0).slots, 2U);
}

TEST_F(HopJoinerTest, waits_for_the_sound_of_a_hop) {
  make();
  begin_all();
  play(10, {1, 0}, true, false);
  EXPECT_EQ(kept.count(), 0U);
  maker.time = 0;
  play(10, {1, 0}, false, true);
  EXPECT_EQ(kept.count(), 10U);
  EXPECT_EQ(sounding(), 10U);
}

TEST_F(HopJoinerTest, never_gives_sound_to_tracks_that_began_before_it) {
  make();
  joiner->begin(StreamKind::tracks, now);
  play(200, {1, 0}, true, false);
  joiner->begin(AudioStream::separated, now);
  play(100, {1, 2});
  EXPECT_EQ(kept.count(), 300U) << "tracks are shown";
  EXPECT_EQ(sounding(), 0U);
  EXPECT_TRUE(is_said("joined under way"));
}

TEST_F(HopJoinerTest, never_gives_sound_to_tracks_that_do_not_begin_with_the_first_hop) {
  make();
  maker.time = 50;
  begin_all();
  play(100, {1, 2});
  EXPECT_EQ(kept.count(), 100U);
  EXPECT_EQ(sounding(), 0U);
  EXPECT_TRUE(is_said("joined under way"));
}

TEST_F(HopJoinerTest, gives_the_right_sound_after_tracks_that_were_lost) {
  make();
  begin_all();
  play(50, {1, 2});
  play(7, {1, 3}, false, true);
  play(50, {4, 3});
  EXPECT_EQ(kept.count(), 100U);
  EXPECT_EQ(sounding(), 100U);
}

TEST_F(HopJoinerTest, notices_sound_that_was_lost) {
  make();
  begin_all();
  play(300, {1, 2});
  EXPECT_EQ(sounding(), 300U);
  play(40, {1, 2}, true, false);  // they never come
  play(500, {1, 2});
  EXPECT_TRUE(is_said("of sound are missing")) << (said.empty() ? "" : said[0]);
  EXPECT_EQ(kept.count(), 840U);
}

TEST_F(HopJoinerTest, notices_sound_of_another_rate) {
  make();
  begin_all();
  for (int i = 0; i < 500; ++i) {
    play(1, {1, 2});
    joiner->add(AudioStream::separated, Grid<float>(2, 128));
  }
  EXPECT_TRUE(is_said("rate")) << (said.empty() ? "" : said[0]);
}

TEST_F(HopJoinerTest, goes_on_without_sound_that_stops_coming) {
  make();
  begin_all();
  play(10, {1, 0});
  play(500, {1, 0}, true, false);
  EXPECT_TRUE(is_said("stopped coming") || is_said("are missing"));
  EXPECT_EQ(kept.count(), 510U);
  EXPECT_EQ(sounding(), 10U);
}

TEST_F(HopJoinerTest, says_that_channels_and_rows_do_not_fit) {
  make();
  maker = test::HopMaker(3);
  joiner->begin(StreamKind::tracks, now);
  joiner->begin(AudioStream::separated, now);
  play(10, {1, 0, 0}, true, false);
  EXPECT_TRUE(is_said("tracks have 3 rows and the sound 2 channels"));
  EXPECT_EQ(kept.count(), 10U);
}

TEST_F(HopJoinerTest, begins_another_run_with_another_connection) {
  make();
  begin_all();
  play(10, {1, 0});
  joiner->end(AudioStream::separated);
  joiner->end(StreamKind::tracks);
  EXPECT_FALSE(kept.running());
  maker.time = 0;
  now += 10s;
  begin_all();
  play(10, {1, 0});
  EXPECT_EQ(sounding(), 20U);
  ASSERT_EQ(kept.infos().size(), 2U);
  EXPECT_NE(kept.infos()[0].run, kept.infos()[1].run);
}

TEST_F(HopJoinerTest, trusts_no_sound_where_stamps_begin_anew_within_a_connection) {
  make();
  begin_all();
  play(10, {1, 0});
  maker.time = 0;
  play(10, {2, 0});
  EXPECT_EQ(kept.infos().size(), 2U);
  EXPECT_EQ(sounding(), 10U);
}

TEST_F(HopJoinerTest, puts_potentials_to_their_hop_and_does_not_wait_for_them_for_long) {
  make();
  joiner->begin(StreamKind::tracks, now);
  joiner->begin(StreamKind::potentials, now);
  for (HopIndex t = 1; t <= 20; ++t) {
    StreamRecord record;
    record.time = t;
    record.tracks.resize(2);
    joiner->add(record, now);
    joiner->give(now);
    EXPECT_EQ(kept.count(), t <= 10 ? t - 1 : 10U) << "its potentials may still come";
    if (t > 10) continue;
    StreamRecord potentials;
    potentials.kind = StreamKind::potentials;
    potentials.time = t;
    potentials.potentials = {{{1, 0, 0}, static_cast<float>(t)}};
    joiner->add(potentials, now);
    joiner->give(now);
  }
  now += 100ms;
  joiner->give(now);
  const auto hops = kept.hops();
  ASSERT_EQ(hops.size(), 20U);
  EXPECT_EQ(hops[4].potentials.at(0).energy, 5);
  EXPECT_TRUE(hops[15].potentials.empty());
}

TEST_F(HopJoinerTest, brings_sound_of_another_rate_to_the_rate_of_the_tracks) {
  HopJoiner::Config config;
  config.sound_rate = 48000;
  make(config);
  begin_all();
  for (int i = 0; i < 100; ++i) {
    StreamRecord record;
    record.time = static_cast<HopIndex>(i + 1);
    record.tracks.resize(2);
    record.tracks[0].id = 1;
    now += 8ms;
    joiner->add(record, now);
    Grid<float> block(2, 384);
    for (std::size_t k = 0; k < 384; ++k) {
      block[0][k] =
          static_cast<float>(0.5 * std::sin(2 * 3.14159265358979 * 250 / 48000 * (384.0 * i + double(k))));
    }
    joiner->add(AudioStream::separated, block);
    joiner->give(now);
  }
  const auto hops = kept.hops();
  ASSERT_GT(hops.size(), 90U);
  for (std::size_t h = 20; h < 80; ++h) {
    for (std::size_t i = 0; i < 128; ++i) {
      ASSERT_NEAR(hops[h].separated.at(0)[i], test::tone_of(1, h * 128 + i), 0.01) << h;
    }
  }
}

}  // namespace
}  // namespace odas::hop_joiner_test
