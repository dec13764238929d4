// SPDX-License-Identifier: MIT
#include "odas/studio/session_recorder.hpp"

#include <cstring>

#include "support/hop_maker.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/studio/session_reader.hpp"

namespace odas::session_recorder_test {
namespace {

using nlohmann::json;

/// The sound of one track or microphone, as the session has it.
struct Heard {
  std::uint64_t first = 0, next = 0;
  std::size_t wrong = 0, gaps = 0;
  bool last = false;
};

std::map<std::pair<std::string, std::uint32_t>, Heard> hear(const SessionReader& reader) {
  std::map<std::pair<std::string, std::uint32_t>, Heard> all;
  SessionReader::Visitor visitor;
  visitor.audio = [&](const std::string& stream, std::span<const char> packet) {
    std::uint32_t id = 0;
    std::uint64_t index = 0;
    std::uint16_t count = 0, flags = 0;
    std::memcpy(&id, packet.data() + 4, 4);
    std::memcpy(&index, packet.data() + 8, 8);
    std::memcpy(&count, packet.data() + 20, 2);
    std::memcpy(&flags, packet.data() + 22, 2);
    ASSERT_EQ(packet.size(), 24U + count * 2U);
    Heard& heard = all[{stream, id}];
    if (heard.next == 0) heard.first = index;
    EXPECT_FALSE(heard.last) << "nothing follows the last";
    const bool gap = heard.next != 0 && index != heard.next;
    EXPECT_EQ((flags & AudioHeader::kGap) != 0, gap);
    heard.gaps += gap ? 1 : 0;
    heard.last = (flags & AudioHeader::kLast) != 0;
    heard.next = index + count;
    for (std::size_t i = 0; i < count; ++i) {
      std::int16_t sample = 0;
      std::memcpy(&sample, packet.data() + 24 + 2 * i, 2);
      if (sample != test::tone_sample(id, index + i)) ++heard.wrong;
    }
  };
  EXPECT_EQ(reader.read(visitor), "");
  return all;
}

TEST(SessionRecorder, keeps_every_sample_under_its_own_id_and_index) {
  const test::Scratch scratch;
  test::HopMaker hops;
  SessionRecorder session(scratch.folder(), {true, true, true});
  ASSERT_TRUE(session.begin(hops.info()).ok());
  for (int i = 0; i < 300; ++i) {
    if (i == 150) hops.time += 5;  // lost
    const std::uint64_t second = i < 100 ? 0 : i < 205 ? 2 : 3;
    ASSERT_TRUE(session.hop(hops.next({i < 37 ? 0U : 1U, second})).ok());
    if (i % 60 == 59) { ASSERT_TRUE(session.flush().ok()); }
  }
  ASSERT_TRUE(session.close().ok());
  const auto heard = hear(SessionReader(scratch / session.name()));
  EXPECT_EQ(heard.size(), 3U + 3U) << "three voices and three microphones";
  for (const auto& [key, voice] : heard) {
    EXPECT_EQ(voice.wrong, 0U) << key.first << " " << key.second;
    EXPECT_EQ(voice.gaps, key.first == "separated" && key.second == 3 ? 0U : 1U);
  }
  EXPECT_EQ(heard.at({"separated", 1}).first, 37U * 128);
  EXPECT_EQ(heard.at({"separated", 2}).next, 210U * 128);
  EXPECT_TRUE(heard.at({"separated", 2}).last);
  EXPECT_FALSE(heard.at({"separated", 3}).last) << "it goes on";
  EXPECT_EQ(heard.at({"raw", 3}).next, 305U * 128);
}

TEST(SessionRecorder, keeps_hops_runs_and_messages_with_their_times) {
  const test::Scratch scratch;
  test::HopMaker hops;
  SessionRecorder session(scratch.folder(), {});
  const StreamInfo info = hops.info();
  hops.time = 999;
  ASSERT_TRUE(session.begin(info, hops.time).ok());
  std::string expected;
  for (int i = 0; i < 10; ++i) {
    const HopResult hop = hops.next({1, 0});
    append_hop(expected, hop);
    ASSERT_TRUE(session.hop(hop).ok());
  }
  ASSERT_TRUE(session.add("event", {{"type", "event"}, {"event", "appear"}}).ok());
  ASSERT_TRUE(session.add("nonsense", {{"type", "nonsense"}}).ok());
  StreamInfo other = info;
  other.run = 2;
  ASSERT_TRUE(session.begin(other).ok());
  ASSERT_TRUE(session.close().ok());

  std::string got;
  std::vector<json> runs, texts;
  std::vector<std::uint64_t> times;
  SessionReader::Visitor visitor;
  visitor.run = [&](const json& run) { runs.push_back(run); };
  visitor.hop = [&](const json& hop, std::uint64_t time) {
    times.push_back(time);
    got += hop.dump();
  };
  visitor.text = [&](const std::string&, const json& message) { texts.push_back(message); };
  EXPECT_EQ(SessionReader(scratch / session.name()).read(visitor), "");
  ASSERT_EQ(times.size(), 10U);
  EXPECT_EQ(times[0], 1769860807992000000U);
  EXPECT_EQ(times[1] - times[0], 8000000U);
  std::string again;
  for (std::size_t at = 0; at < expected.size();) {
    const std::size_t end = expected.find("{\"t\"", at + 1);
    again += json::parse(expected.substr(at, end - at)).dump();
    at = std::min(end, expected.size());
  }
  EXPECT_EQ(got, again);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0], run_message(info));
  EXPECT_EQ(runs[1]["id"], 2);
  EXPECT_EQ(texts, (std::vector<json>{{{"type", "event"}, {"event", "appear"}}}));
}

TEST(SessionRecorder, a_killed_one_has_everything_up_to_the_last_flush) {
  const test::Scratch scratch;
  test::HopMaker hops;
  SessionRecorder session(scratch.folder(), {true, false, true});
  ASSERT_TRUE(session.begin(hops.info()).ok());
  for (int i = 0; i < 250; ++i) ASSERT_TRUE(session.hop(hops.next({1, 2})).ok());
  ASSERT_TRUE(session.flush().ok());
  const SessionInfo info = SessionReader(scratch / session.name()).info();
  EXPECT_NEAR(info.seconds, 2, 0.05);
  EXPECT_EQ(info.fault.substr(0, 20), "was cut off after 2.") << info.fault;
  EXPECT_EQ(info.audio, (std::vector<std::string>{"separated", "raw"}));
  EXPECT_TRUE(info.ours);
}

TEST(SessionRecorder, a_folder_that_cannot_be_written_is_said) {
  EXPECT_THROW(SessionRecorder("/nowhere/at/all", {}), IoError);
}

}  // namespace
}  // namespace odas::session_recorder_test
