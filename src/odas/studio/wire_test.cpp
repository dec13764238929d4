// SPDX-License-Identifier: MIT
#include "odas/studio/wire.hpp"

#include <cmath>
#include <limits>

#include "support/fake_io.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::wire_test {
namespace {

using nlohmann::json;

test::HopOfHand one_voice() {
  test::HopOfHand hop;
  hop.tracks.resize(2);
  hop.tracks[1] = {7, "door \"1\"", {0, 1, 0}, 0.5F, Category::speech};
  hop.potentials = {{{1, 0, 0}, 0.25F}};
  hop.separated = Grid<float>(2, 4);
  for (float& x : hop.separated[1]) x = 0.1F;
  return hop;
}

TEST(Wire, a_hop_says_who_is_where_and_how_loud) {
  std::string text;
  append_hop(text, one_voice().result(12));
  const json hop = json::parse(text);
  EXPECT_EQ(hop["t"], 12);
  ASSERT_EQ(hop["tracks"].size(), 1U) << "empty slots are left out";
  EXPECT_EQ(hop["tracks"][0], (json{1, 7, 0.0, 1.0, 0.0, 0.5, -20.0, 2, "door \"1\""}));
  EXPECT_EQ(hop["potentials"], (json{{1.0, 0.0, 0.0, 0.25}}));
}

TEST(Wire, a_hop_may_be_without_potentials_sound_and_finite_numbers) {
  test::HopOfHand hop = one_voice();
  hop.separated = {};
  hop.tracks[1].tag = "dynamic";
  hop.tracks[1].direction.x = std::numeric_limits<float>::quiet_NaN();
  std::string text;
  append_hop(text, hop.result(1), false);
  const json read = json::parse(text);
  EXPECT_FALSE(read.contains("potentials"));
  EXPECT_EQ(read["tracks"][0], (json{1, 7, 0.0, 1.0, 0.0, 0.5, nullptr, 2}));
}

TEST(Wire, a_silent_voice_has_a_level_that_is_a_number) {
  test::HopOfHand hop = one_voice();
  hop.separated.fill(0);
  std::string text;
  append_hop(text, hop.result(1));
  EXPECT_EQ(json::parse(text)["tracks"][0][6], -120.0);
}

TEST(Wire, a_binary_message_begins_with_24_bytes_in_the_order_of_the_protocol) {
  std::vector<char> bytes;
  append_header(bytes, {AudioStream::raw, 0x01020304, 0x1112131415161718, 48000, 0x0102, AudioHeader::kLast});
  ASSERT_EQ(bytes.size(), AudioHeader::kSize);
  const std::string expected{1,    1,    1,    2,    4,          3,          2, 1, 0x18, 0x17, 0x16, 0x15,
                             0x14, 0x13, 0x12, 0x11, char(0x80), char(0xBB), 0, 0, 2,    1,    2,    0};
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), expected);
}

TEST(Wire, a_run_has_its_microphones_and_its_time) {
  StreamInfo info;
  info.run = 3;
  info.kind = StreamInfo::Kind::odas;
  info.mics.resize(1);
  info.mics[0].mu = {1, 2, 3};
  info.channels = {4};
  info.start = std::chrono::system_clock::time_point(std::chrono::milliseconds(1769860800125));
  const json run = run_message(info);
  EXPECT_EQ(run["id"], 3);
  EXPECT_EQ(run["kind"], "odas");
  EXPECT_EQ(run["start"], "2026-01-31T12:00:00.125Z");
  EXPECT_EQ(run["mics"][0]["channel"], 4);
  EXPECT_EQ(run["mics"][0]["position"], (json{1.0, 2.0, 3.0}));
}

}  // namespace
}  // namespace odas::wire_test
