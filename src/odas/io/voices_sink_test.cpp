// SPDX-License-Identifier: MIT
#include "odas/io/voices_sink.hpp"

#include <set>
#include <string>
#include <tuple>

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.hh>

namespace odas::voices_sink_test {
namespace {

using namespace std::chrono_literals;

// 2025-01-31 12:00:00
const std::chrono::system_clock::time_point kStart{1738324800s};

PipelineConfig config_without_delay() {
  PipelineConfig config = test::small_configuration().pipeline;
  config.general.size.frame_size = config.general.size.hop_size;
  return config;
}

/// A hop of two slots whose audio is `level`; id 0: an empty slot.
struct Hop : test::HopOfHand {
  Hop(std::uint64_t first, std::uint64_t second, float level) {
    tracks.resize(2);
    tracks[0].id = first;
    tracks[0].tag = "dynamic";
    tracks[0].direction = {1, 0, 0};
    tracks[1].id = second;
    tracks[1].tag = "door";
    tracks[1].direction = {0, 1, 0};
    separated = postfiltered = Grid<float>(2, 128);
    separated.fill(level);
  }
};

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

nlohmann::json json_in(const std::filesystem::path& file) {
  return nlohmann::json::parse(test::content(file));
}

TEST(VoicesSink, writes_a_wav_and_its_story_for_each_voice) {
  const test::Scratch scratch;
  VoicesSink sink(scratch / "voices", AudioSink::Stream::separated, config_without_delay(), 1, kStart);
  for (HopIndex hop = 1; hop <= 50; ++hop) {
    EXPECT_TRUE(sink.write(Hop(hop >= 11 ? 7 : 0, hop <= 25 ? 3 : 0, 0.25F).result(hop)).ok());
  }
  EXPECT_TRUE(sink.close().ok());
  EXPECT_EQ(
      names_in(scratch / "voices"),
      (std::set<std::string>{"20250131T120000.000Z_source_3.json", "20250131T120000.000Z_source_3.wav",
                             "20250131T120000.080Z_source_7.json", "20250131T120000.080Z_source_7.wav"}));
  SndfileHandle wav((scratch / "voices/20250131T120000.080Z_source_7.wav").string());
  EXPECT_EQ(wav.frames(), 40 * 128);
  EXPECT_EQ(wav.channels(), 1);
  const auto story = json_in(scratch / "voices/20250131T120000.000Z_source_3.json");
  EXPECT_EQ(story["id"], 3);
  EXPECT_EQ(story["tag"], "door");
  EXPECT_EQ(story["fS"], 16000);
  EXPECT_EQ(story["start"], 0.0);
  EXPECT_EQ(story["utc"], "2025-01-31T12:00:00.000Z");
  EXPECT_EQ(story["seconds"], 0.2);
  EXPECT_EQ(story["azimuth"], 90.0);
  EXPECT_EQ(story["directions"].size(), 3U) << "ten a second";
}

TEST(VoicesSink, begins_with_the_sound_of_before_where_the_voices_are_late) {
  const test::Scratch scratch;
  PipelineConfig config = config_without_delay();
  config.sss.lookback = 80;
  VoicesSink sink(scratch / "voices", AudioSink::Stream::separated, config, 1, kStart);
  for (HopIndex hop = 1; hop <= 30; ++hop)
    EXPECT_TRUE(sink.write(Hop(hop > 20 ? 1 : 0, 0, 0.1F).result(hop)).ok());
  EXPECT_TRUE(sink.close().ok());
  EXPECT_EQ(json_in(scratch / "voices/20250131T120000.080Z_source_1.json")["start"], 0.08);
}

TEST(VoicesSink, one_who_comes_back_gets_another_file_and_nothing_is_overwritten) {
  const test::Scratch scratch;
  for (int run = 0; run < 2; ++run) {
    VoicesSink sink(scratch / "voices", AudioSink::Stream::separated, config_without_delay(), 1,
                    kStart + run * 1h);
    for (HopIndex hop = 1; hop <= 50; ++hop) {
      EXPECT_TRUE(sink.write(Hop(hop < 10 ? 1 : 0, hop > 40 ? 1 : 0, 0.1F).result(hop)).ok());
    }
    EXPECT_TRUE(sink.close().ok());
  }
  EXPECT_EQ(names_in(scratch / "voices").size(), 8U) << "two runs, two files, two stories";
}

TEST(VoicesSink, keeps_stories_apart_when_it_is_brought_up_to_date_between_voices) {
  const test::Scratch scratch;
  VoicesSink sink(scratch / "voices", AudioSink::Stream::separated, config_without_delay(), 1, kStart);
  const auto hops = [&](std::uint64_t first, std::uint64_t second, HopIndex from, HopIndex to) {
    for (HopIndex hop = from; hop <= to; ++hop)
      EXPECT_TRUE(sink.write(Hop(first, second, 0.1F).result(hop)).ok());
    EXPECT_TRUE(sink.flush().ok());
  };
  hops(1, 2, 1, 10);
  hops(3, 2, 11, 20);  // 1 has gone, 2 goes on
  hops(3, 0, 21, 30);
  hops(4, 5, 31, 40);
  EXPECT_TRUE(sink.close().ok());
  for (const auto& [file, id, seconds] : {std::tuple{"000Z_source_1", 1, 0.08},
                                          {"000Z_source_2", 2, 0.16},
                                          {"080Z_source_3", 3, 0.16},
                                          {"240Z_source_4", 4, 0.08},
                                          {"240Z_source_5", 5, 0.08}}) {
    const auto story = json_in(scratch / "voices" / (std::string("20250131T120000.") + file + ".json"));
    EXPECT_EQ(story["id"], id);
    EXPECT_EQ(story["seconds"], seconds) << file;
    EXPECT_EQ(story["tag"], id == 2 || id == 5 ? "door" : "dynamic") << file;
  }
}

TEST(VoicesSink, what_is_there_after_a_flush_is_whole) {
  const test::Scratch scratch;
  VoicesSink sink(scratch / "voices", AudioSink::Stream::separated, config_without_delay(), 1, kStart);
  for (HopIndex hop = 1; hop <= 10; ++hop) EXPECT_TRUE(sink.write(Hop(1, 0, 2).result(hop)).ok());
  EXPECT_TRUE(sink.flush().ok());
  SndfileHandle wav((scratch / "voices/20250131T120000.000Z_source_1.wav").string());
  EXPECT_EQ(wav.frames(), 10 * 128);
  EXPECT_EQ(json_in(scratch / "voices/20250131T120000.000Z_source_1.json")["seconds"], 0.08);
  EXPECT_EQ(sink.clipped_samples(), 10U * 128);
}

TEST(CompactTime, sorts_and_has_milliseconds) {
  EXPECT_EQ(compact_time(kStart), "20250131T120000.000Z");
  EXPECT_EQ(compact_time(kStart + 7ms), "20250131T120000.007Z");
}

}  // namespace
}  // namespace odas::voices_sink_test
