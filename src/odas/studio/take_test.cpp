// SPDX-License-Identifier: MIT
#include "odas/studio/take.hpp"

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"

namespace odas::take_test {
namespace {

using nlohmann::json;

TakeHead a_voice() {
  TakeHead head;
  head.track = 12;
  head.tag = "door";
  head.start_s = 3.5;
  head.start = std::chrono::system_clock::time_point(std::chrono::milliseconds(1769860800125));
  head.config_name = "array";
  head.config_hash = "9f86d081";
  return head;
}

TEST(Take, is_named_after_its_time_and_its_source_and_overwrites_nothing) {
  const test::Scratch scratch;
  Take first(scratch.folder(), a_voice()), second(scratch.folder(), a_voice());
  EXPECT_EQ(first.name(), "20260131T120000.125Z_source_12.wav");
  EXPECT_EQ(second.name(), "20260131T120000.125Z_source_12_2.wav");
  TakeHead raw = a_voice();
  raw.stream = AudioStream::raw;
  EXPECT_EQ(Take(scratch.folder(), raw).name(), "20260131T120000.125Z_raw.wav");
}

TEST(Take, tells_in_the_json_beside_it_what_it_is) {
  const test::Scratch scratch;
  Take take(scratch.folder(), a_voice());
  take.steer(3.5, {0, 1, 0});
  take.steer(3.55, {1, 0, 0});  // too soon: ten a second
  take.steer(3.6, {0, 1, 0});
  ASSERT_TRUE(take.write(std::vector<char>(32000)).ok());
  ASSERT_TRUE(take.write_silence(16000).ok());
  take.add({4, 5, "good morning"});
  ASSERT_TRUE(take.set_label("the guest").ok());
  ASSERT_TRUE(take.close().ok());
  const json told = json::parse(test::content(scratch / "20260131T120000.125Z_source_12.json"));
  EXPECT_EQ(told["made_by"], "odas studio");
  EXPECT_EQ(told["file"], "20260131T120000.125Z_source_12.wav");
  EXPECT_EQ(told["id"], 12);
  EXPECT_EQ(told["tag"], "door");
  EXPECT_EQ(told["label"], "the guest");
  EXPECT_EQ(told["stream"], "separated");
  EXPECT_EQ(told["fS"], 16000);
  EXPECT_EQ(told["start"], 3.5);
  EXPECT_EQ(told["utc"], "2026-01-31T12:00:00.125Z");
  EXPECT_EQ(told["seconds"], 2.0);
  EXPECT_EQ(told["config_hash"], "9f86d081");
  EXPECT_EQ(told["azimuth"], 90.0);
  EXPECT_EQ(told["directions"].size(), 2U);
  EXPECT_EQ(told["gaps"], (json{{1.0, 1.0}}));
  EXPECT_EQ(told["transcript"][0]["text"], "good morning");
}

TEST(Take, is_good_after_each_flush_though_nobody_closes_it) {
  const test::Scratch scratch;
  Take take(scratch.folder(), a_voice());
  ASSERT_TRUE(take.write(std::vector<char>(32000)).ok());
  ASSERT_TRUE(take.flush().ok());
  const std::string wav = test::content(scratch / take.name());
  EXPECT_EQ(wav.size(), kWavHeaderSize + 32000);
  const WavHeaderBytes header = wav_header({16000, 1, 16}, wav.size());
  EXPECT_EQ(wav.substr(0, kWavHeaderSize), std::string(header.begin(), header.end()));
}

TEST(Take, that_is_over_can_still_be_given_its_words) {
  const test::Scratch scratch;
  Take take(scratch.folder(), a_voice());
  ASSERT_TRUE(take.close().ok());
  const auto file = scratch / "20260131T120000.125Z_source_12.json";
  ASSERT_TRUE(add_transcript(file, {1, 2, "late"}).ok());
  EXPECT_EQ(json::parse(test::content(file))["transcript"][0]["text"], "late");
  test::write_file(scratch / "foreign.json", "{}");
  ASSERT_TRUE(add_transcript(scratch / "foreign.json", {1, 2, "late"}).ok());
  EXPECT_EQ(test::content(scratch / "foreign.json"), "{}");
}

TEST(Take, of_a_full_disk_is_an_error_and_leaves_a_whole_file) {
  const test::Scratch scratch;
  EXPECT_THROW(Take("/nowhere/at/all", a_voice()), IoError);
  Take take(scratch.folder(), a_voice());
  const test::FileSizeLimit limit(20001);
  IoStatus status = take.write(std::vector<char>(10000));
  for (int i = 0; i < 10 && status.ok(); ++i) status = take.write(std::vector<char>(10000));
  if (status.ok()) status = take.flush();
  EXPECT_FALSE(status.ok());
  static_cast<void>(take.close().ok());
  EXPECT_EQ(std::filesystem::file_size(scratch / take.name()) % 2, 0U);
}

}  // namespace
}  // namespace odas::take_test
