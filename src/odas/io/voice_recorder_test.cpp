// SPDX-License-Identifier: MIT
#include "odas/io/voice_recorder.hpp"

#include <fstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::voice_recorder_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHop = 128;
const VoiceRecorder::Format kFormat{16000, 0.008, 0.008, 1};

class VoiceRecorderTest : public testing::Test {
 protected:
  /// Hops 1..n, each sample telling its hop and slot: hop/1000 + slot/10.
  static void run(VoiceRecorder& recorder, const std::vector<std::array<std::uint64_t, 2>>& ids) {
    Grid<float> audio(2, kHop);
    HopIndex time = 0;
    for (const auto& pair : ids) {
      ++time;
      std::array<Track, 2> tracks;
      for (std::size_t slot = 0; slot < 2; ++slot) {
        tracks[slot].id = pair[slot];
        std::ranges::fill(audio[slot], static_cast<float>(time) / 1000 + static_cast<float>(slot) / 10);
      }
      ASSERT_TRUE(recorder.add(time, tracks, audio).ok());
    }
    ASSERT_TRUE(recorder.close().ok());
  }

  [[nodiscard]] std::vector<float> samples(const std::string& file) const {
    SndfileHandle sound((folder_ / file).string());
    std::vector<float> result(static_cast<std::size_t>(sound.frames()));
    sound.readf(result.data(), sound.frames());
    return result;
  }

  test::Scratch scratch_;
  fs::path folder_ = scratch_ / "out";
};

TEST_F(VoiceRecorderTest, a_source_that_comes_back_does_not_overwrite_what_it_said) {
  VoiceRecorder recorder(folder_, kFormat);
  run(recorder, {{5, 0}, {0, 0}, {0, 5}, {0, 5}});
  ASSERT_EQ(recorder.voices().size(), 2U);
  EXPECT_EQ(recorder.voices()[1].file, "source_5_2.wav");
  EXPECT_EQ(samples("source_5.wav").size(), kHop);
  EXPECT_EQ(samples("source_5_2.wav").size(), 2 * kHop);
  const VoiceRecorder next(folder_, kFormat);
  EXPECT_TRUE(fs::is_empty(folder_)) << "the next run removes both";
}

TEST_F(VoiceRecorderTest, writes_each_source_from_its_birth_to_its_death) {
  VoiceRecorder recorder(folder_, kFormat);
  run(recorder, {{0, 0}, {0, 5}, {0, 5}, {7, 5}, {7, 0}});
  ASSERT_EQ(recorder.voices().size(), 2U);
  EXPECT_EQ(recorder.voices()[0].id, 5U);
  EXPECT_EQ(recorder.voices()[0].file, "source_5.wav");
  EXPECT_NEAR(recorder.voices()[0].start_s, 0.0, 1e-9);  // born in the second hop, heard a hop late
  EXPECT_NEAR(recorder.voices()[0].seconds, 3 * 0.008, 1e-9);
  EXPECT_NEAR(recorder.voices()[1].start_s, 0.016, 1e-9);
  const auto five = samples("source_5.wav");
  ASSERT_EQ(five.size(), 3 * kHop);
  EXPECT_NEAR(five.front(), 0.102F, 1e-4F);
  EXPECT_NEAR(five.back(), 0.104F, 1e-4F);
  const auto seven = samples("source_7.wav");
  ASSERT_EQ(seven.size(), 2 * kHop);
  EXPECT_NEAR(seven.front(), 0.004F, 1e-4F);
}

TEST_F(VoiceRecorderTest, parts_two_sources_that_follow_each_other_in_one_slot) {
  VoiceRecorder recorder(folder_, kFormat);
  run(recorder, {{1, 0}, {1, 0}, {2, 0}});
  EXPECT_EQ(samples("source_1.wav").size(), 2 * kHop);
  EXPECT_EQ(samples("source_2.wav").size(), kHop);
}

TEST_F(VoiceRecorderTest, can_forget_finished_voices_while_others_go_on) {
  VoiceRecorder::Format format = kFormat;
  format.file_name = [](std::uint64_t id, double) { return "voice_" + std::to_string(id) + ".wav"; };
  VoiceRecorder recorder(folder_, format);
  const Grid<float> audio(2, kHop);
  std::array<Track, 2> tracks;
  tracks[0].id = 1;
  tracks[1].id = 2;
  ASSERT_TRUE(recorder.add(1, tracks, audio).ok());
  tracks[0].id = 0;
  ASSERT_TRUE(recorder.add(2, tracks, audio).ok());
  recorder.forget(0);
  ASSERT_EQ(recorder.voices().size(), 1U);
  EXPECT_EQ(recorder.voices()[0].id, 2U);
  EXPECT_EQ(recorder.voice_of(1), 0U);
  ASSERT_TRUE(recorder.add(3, tracks, audio).ok());
  ASSERT_TRUE(recorder.close().ok());
  EXPECT_EQ(samples("voice_2.wav").size(), 3 * kHop);
  EXPECT_EQ(samples("voice_1.wav").size(), kHop);
}

TEST_F(VoiceRecorderTest, removes_the_voices_of_an_earlier_run_and_nothing_else) {
  fs::create_directories(folder_);
  for (const char* name : {"source_99.wav", "index.json", "source_mine.wav", "notes.txt", "source_.wav"}) {
    std::ofstream(folder_ / name) << "x";
  }
  VoiceRecorder recorder(folder_, kFormat);
  run(recorder, {{1, 0}});
  EXPECT_FALSE(fs::exists(folder_ / "source_99.wav"));
  EXPECT_FALSE(fs::exists(folder_ / "index.json"));
  EXPECT_TRUE(fs::exists(folder_ / "source_mine.wav"));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
  EXPECT_TRUE(fs::exists(folder_ / "source_.wav"));
  EXPECT_TRUE(fs::exists(folder_ / "source_1.wav"));
}

TEST_F(VoiceRecorderTest, refuses_a_folder_that_is_a_file) {
  std::ofstream(folder_) << "x";
  EXPECT_THROW(VoiceRecorder(folder_, kFormat), IoError);
}

TEST_F(VoiceRecorderTest, is_valid_after_each_flush) {
  VoiceRecorder recorder(folder_, kFormat);
  Grid<float> audio(1, kHop);
  Track track;
  track.id = 1;
  for (HopIndex t = 1; t <= 10; ++t) ASSERT_TRUE(recorder.add(t, {&track, 1}, audio).ok());
  ASSERT_TRUE(recorder.flush().ok());
  EXPECT_EQ(samples("source_1.wav").size(), 10 * kHop);
}

TEST_F(VoiceRecorderTest, holds_what_its_gain_makes_too_loud_and_counts_it) {
  VoiceRecorder::Format loud = kFormat;
  loud.gain = 8;
  VoiceRecorder recorder(folder_, loud);
  Grid<float> audio(2, kHop);
  audio.fill(0.25F);
  const std::array<Track, 2> tracks{Track{.id = 1}, Track{}};
  ASSERT_TRUE(recorder.add(1, tracks, audio).ok());
  ASSERT_TRUE(recorder.close().ok());
  EXPECT_EQ(recorder.clipped_samples(), kHop) << "only what is written counts";
  EXPECT_NEAR(samples("source_1.wav").front(), 1, 1e-4);
}

TEST_F(VoiceRecorderTest, lists_the_voices_with_their_places) {
  VoiceRecorder recorder(folder_, kFormat);
  run(recorder, {{0, 3}, {0, 3}});
  SourceHistory source;
  source.id = 3;
  source.tag = "\"dynamic\"";
  source.active_share = 0.75;
  source.mean = direction_of(30, 10);
  write_voice_index(folder_ / "index.json", recorder.voices(), std::array{source});
  const auto index = nlohmann::json::parse(std::ifstream(folder_ / "index.json"));
  ASSERT_EQ(index.size(), 1U);
  EXPECT_EQ(index[0]["id"], 3);
  EXPECT_EQ(index[0]["tag"], "\"dynamic\"");
  EXPECT_EQ(index[0]["file"], "source_3.wav");
  EXPECT_NEAR(index[0]["seconds"], 0.016, 1e-9);
  EXPECT_NEAR(index[0]["azimuth"], 30, 0.01);
  EXPECT_NEAR(index[0]["active"], 0.75, 1e-9);
}

}  // namespace
}  // namespace odas::voice_recorder_test
