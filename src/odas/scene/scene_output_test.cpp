// SPDX-License-Identifier: MIT
#include "odas/scene/scene_output.hpp"

#include <fstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.h>

#include "odas/base/error.hpp"
#include "odas/scene/simulate.hpp"
#include "odas/scene/sound.hpp"

namespace odas::scene_output_test {
namespace {

class SceneOutput : public ::testing::Test {
 protected:
  void SetUp() override {
    scene_.seconds = 0.5;
    scene_.mics = {{{-0.03F, 0, 0}, {0, 0, 1}, 1}, {{0.03F, 0, 0}, {0, 0, 1}, 1}};
    SceneSource source;
    source.name = "tone";
    source.sound.assign(8000, 0);
    for (std::size_t n = 2000; n < 6000; ++n) source.sound[n] = n % 20 < 10 ? 0.1F : -0.1F;
    source.path = {{0, 30, 0, 1}};
    scene_.sources = {source};
    result_ = simulate(scene_);
  }

  test::Scratch scratch_;
  std::filesystem::path folder_ = scratch_.folder();
  Scene scene_;
  SimulatedScene result_;
};

TEST_F(SceneOutput, Sounds_are_written_to_16_bit) {
  for (const auto format : {RecordingFormat::wav, RecordingFormat::flac}) {
    write_scene(scene_, result_, format, folder_);
    const auto mics = read_mono(folder_ / (format == RecordingFormat::wav ? "mics.wav" : "mics.flac"), 16000);
    const auto image = read_mono(folder_ / "image_0.wav", 16000);
    ASSERT_EQ(mics.size(), 8000U);
    for (std::size_t n = 0; n < mics.size(); ++n) {
      ASSERT_NEAR(mics[n], result_.mics[0][n], 0.51 / 32768);
      ASSERT_NEAR(image[n], result_.images[0][n], 0.51 / 32768);
    }
  }
}

TEST_F(SceneOutput, What_the_machine_plays_is_the_last_channel) {
  scene_.sources[0].is_played = true;
  scene_.sources[0].is_target = false;
  const SimulatedScene result = simulate(scene_);
  EXPECT_EQ(result.mics.rows(), 2U);
  EXPECT_EQ(result.mics[0][4000], result_.mics[0][4000]) << "it is heard as any other";
  write_scene(scene_, result, RecordingFormat::wav, folder_);
  SF_INFO info{};
  SNDFILE* file = sf_open((folder_ / "mics.wav").c_str(), SFM_READ, &info);
  ASSERT_NE(file, nullptr);
  ASSERT_EQ(info.channels, 3);
  std::vector<float> frames(3 * 8000);
  EXPECT_EQ(sf_readf_float(file, frames.data(), 8000), 8000);
  sf_close(file);
  for (std::size_t n = 0; n < 8000; ++n) {
    ASSERT_NEAR(frames[3 * n + 2], scene_.sources[0].sound[n], 0.51 / 32768) << n;
  }
}

TEST_F(SceneOutput, Truth_has_a_direction_and_an_activity_for_each_hop) {
  write_scene(scene_, result_, RecordingFormat::wav, folder_);
  std::ifstream in(folder_ / "truth.json");
  const auto truth = nlohmann::json::parse(in);
  EXPECT_EQ(truth["fs"], 16000);
  EXPECT_EQ(truth["hop"], 128);
  EXPECT_EQ(truth["scene"]["seconds"], 0.5);
  ASSERT_EQ(truth["sources"].size(), 1U);
  ASSERT_EQ(truth["sources"][0]["doa"].size(), scene_.hops());
  ASSERT_EQ(truth["sources"][0]["active"].size(), scene_.hops());
  EXPECT_EQ(truth["sources"][0]["active"][0], 0);
  EXPECT_EQ(truth["sources"][0]["active"][30], 1);
  EXPECT_NEAR(truth["sources"][0]["doa"][5][1].get<double>(), 0.5, 1e-5);
}

TEST_F(SceneOutput, A_folder_that_cannot_be_made_is_said) {
  EXPECT_THROW(write_scene(scene_, result_, RecordingFormat::wav, "/proc/no/such/folder"), IoError);
}

}  // namespace
}  // namespace odas::scene_output_test
