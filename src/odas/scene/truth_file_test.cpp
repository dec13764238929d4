// SPDX-License-Identifier: MIT
#include "odas/scene/truth_file.hpp"

#include <fstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::truth_file_test {
namespace {

namespace fs = std::filesystem;

/// Two hops and a half: the half does not count.
constexpr const char* kTruth = R"({"fs":16000,"hop":128,"scene":{"seconds":0.02},"sources":[
  {"doa":[[1,0,0],[0,1,0]],"active":[0,1]},
  {"doa":[[0,0,1],[0,0,1]],"active":[true,false]}]})";

class TruthFile : public ::testing::Test {
 protected:
  void write(const char* text) const { std::ofstream(folder_ / "truth.json") << text; }
  void write_sound(const char* name, int channels, int rate) const {
    SndfileHandle wav((folder_ / name).string(), SFM_WRITE, SF_FORMAT_WAV | SF_FORMAT_PCM_16, channels, rate);
    std::vector<short> samples(static_cast<std::size_t>(channels) * 320);
    for (std::size_t n = 0; n < samples.size(); ++n) samples[n] = static_cast<short>(n);
    wav.writef(samples.data(), 320);
  }
  [[nodiscard]] std::string complaint() const {
    try {
      static_cast<void>(read_truth(folder_));
    } catch (const IoError& error) { return error.what(); }
    return {};
  }

  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

TEST_F(TruthFile, gives_directions_and_activity_by_hops) {
  write(kTruth);
  for (const fs::path& path : {folder_, folder_ / "truth.json"}) {
    const KnownScene scene = read_truth(path);
    EXPECT_EQ(scene.hops, 2U);
    ASSERT_EQ(scene.sources.size(), 2U);
    EXPECT_EQ(scene.sources[0].direction[1].y, 1);
    EXPECT_EQ(scene.sources[0].active, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(scene.sources[1].active, (std::vector<std::uint8_t>{1, 0}));
  }
}

TEST_F(TruthFile, counts_as_many_hops_as_the_reference_scorer) {
  // 16 / 0.008 and 20 / 0.008 are whole in double precision too.
  write(R"({"fs":16000,"hop":128,"scene":{"seconds":16},"sources":[]})");
  EXPECT_EQ(read_truth(folder_).hops, 2000U);
  write(R"({"fs":16000,"hop":128,"scene":{"seconds":20},"sources":[]})");
  EXPECT_EQ(read_truth(folder_).hops, 2500U);
}

TEST_F(TruthFile, says_what_is_wrong_with_it) {
  EXPECT_NE(complaint().find("there is no "), std::string::npos) << complaint();
  write("{\"fs\":16000");
  EXPECT_NE(complaint().find("is not the truth of a scene"), std::string::npos) << complaint();
  write(R"({"fs":16000,"hop":128,"scene":{"seconds":0.02},"sources":[{"doa":[[1,0,0]],"active":[0,1]}]})");
  EXPECT_NE(complaint().find("1 directions and 2 times active, where there are 2 hops"), std::string::npos)
      << complaint();
  write(R"({"fs":16000,"hop":0,"scene":{"seconds":0.02},"sources":[]})");
  EXPECT_NE(complaint().find("must be over 0"), std::string::npos) << complaint();
}

TEST_F(TruthFile, has_the_sound_beside_it_the_first_channel_of_each) {
  write(kTruth);
  const KnownScene scene = read_truth(folder_);
  EXPECT_FALSE(read_known_sound(folder_, scene).has_value());
  write_sound("mics.wav", 4, 16000);
  write_sound("image_0.wav", 1, 16000);
  EXPECT_THROW(static_cast<void>(read_known_sound(folder_, scene)), IoError);
  write_sound("image_1.wav", 1, 16000);
  const auto sound = read_known_sound(folder_ / "truth.json", scene);
  ASSERT_TRUE(sound.has_value());
  EXPECT_EQ(sound->mic.size(), 320U);
  EXPECT_EQ(sound->mic[10], 40.F / 32768);
  ASSERT_EQ(sound->images.size(), 2U);
  EXPECT_EQ(sound->images[1][10], 10.F / 32768);
}

TEST_F(TruthFile, does_not_take_sound_of_another_rate) {
  write(kTruth);
  write_sound("mics.wav", 4, 48000);
  EXPECT_THROW(static_cast<void>(read_known_sound(folder_, read_truth(folder_))), IoError);
}

}  // namespace
}  // namespace odas::truth_file_test
