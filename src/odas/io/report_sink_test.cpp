// SPDX-License-Identifier: MIT
#include "odas/io/report_sink.hpp"

#include <fstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::report_sink_test {
namespace {

namespace fs = std::filesystem;

class ReportSinkTest : public testing::Test {
 protected:
  static HopResult hop(HopIndex time, const std::array<Track, 1>& tracks, const Grid<float>& audio) {
    HopResult result;
    result.time = time;
    result.tracks = tracks;
    result.separated = audio;
    return result;
  }

  test::Scratch scratch_;
  fs::path folder_ = scratch_ / "out";
};

TEST_F(ReportSinkTest, writes_the_voices_with_their_gain_and_remembers_their_way) {
  PipelineConfig config;
  config.sss.gain_sep = 2;
  ReportSink sink(folder_, config);
  Grid<float> audio(1, 128);
  audio.fill(0.25F);
  Track track;
  track.id = 4;
  track.direction = direction_of(60, 0);
  track.activity = 1;
  for (HopIndex t = 11; t <= 20; ++t) ASSERT_TRUE(sink.write(hop(t, {track}, audio)).ok());
  ASSERT_TRUE(sink.close().ok());

  SndfileHandle sound((folder_ / "voices/source_4.wav").string());
  ASSERT_EQ(sound.frames(), 1280);
  float first = 0;
  sound.readf(&first, 1);
  EXPECT_NEAR(first, 0.5F, 1e-4F);
  ASSERT_EQ(sink.history().sources().size(), 1U);
  // Hop 11 is 80 ms in; the voice comes a hop late.
  EXPECT_NEAR(sink.voices()[0].start_s, 0.072, 1e-9);
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(folder_ / "voices/index.json"))[0]["id"], 4);
}

TEST_F(ReportSinkTest, says_what_it_could_not_write) {
  ReportSink sink(folder_, PipelineConfig{});
  fs::remove_all(folder_);
  Track track;
  track.id = 1;
  const IoStatus status = sink.write(hop(1, {track}, Grid<float>(1, 128)));
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.what().find("source_1.wav"), std::string::npos) << status.what();
  EXPECT_FALSE(sink.close().ok());
}

}  // namespace
}  // namespace odas::report_sink_test
