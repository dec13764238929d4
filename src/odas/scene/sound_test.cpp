// SPDX-License-Identifier: MIT
#include "odas/scene/sound.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.h>

#include "odas/base/error.hpp"
#include "odas/scene/activity.hpp"

namespace odas::sound_test {
namespace {

class Sound : public ::testing::Test {
 protected:
  /// 440 Hz on the first of two channels.
  std::filesystem::path write_tone(int rate) {
    const auto file = folder_ / "tone.wav";
    SF_INFO info{};
    info.samplerate = rate;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
    SNDFILE* out = sf_open(file.c_str(), SFM_WRITE, &info);
    for (int n = 0; n < rate; ++n) {
      const float frame[2] = {static_cast<float>(std::sin(2 * std::numbers::pi * 440 * n / rate)), 0.7F};
      sf_writef_float(out, frame, 1);
    }
    sf_close(out);
    return file;
  }

  test::Scratch scratch_;
  std::filesystem::path folder_ = scratch_.folder();
};

TEST_F(Sound, First_channel_is_read_and_resampled) {
  for (const int rate : {16000, 44100}) {
    const auto sound = read_mono(write_tone(rate), 16000);
    ASSERT_NEAR(static_cast<double>(sound.size()), 16000, 2);
    for (std::size_t n = 2000; n < 14000; ++n) {
      const double expected = std::sin(2 * std::numbers::pi * 440 * static_cast<double>(n) / 16000);
      ASSERT_NEAR(sound[n], expected, 2e-3) << rate;
    }
  }
}

TEST_F(Sound, Missing_file_is_named) {
  try {
    (void)read_mono(folder_ / "nobody.wav", 16000);
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("nobody.wav"), std::string::npos);
  }
}

TEST_F(Sound, Starts_when_asked_and_is_as_loud_as_asked_whatever_the_file_was) {
  SoundRecipe recipe;
  recipe.kind = SoundRecipe::Kind::file;
  recipe.file = write_tone(16000);
  recipe.start = 0.5;
  recipe.gain_db = 6;
  const auto sound = make_sound(recipe, 16000, 32000, 1);
  ASSERT_EQ(sound.size(), 32000U);
  double power = 0;
  for (std::size_t n = 0; n < 8000; ++n) ASSERT_EQ(sound[n], 0);
  for (std::size_t n = 8000; n < 24000; ++n) power += static_cast<double>(sound[n]) * sound[n] / 16000;
  EXPECT_NEAR(10 * std::log10(power), -24, 0.2);
}

TEST_F(Sound, Words_are_spoken_or_it_is_said_what_to_install) {
  SoundRecipe recipe;
  recipe.kind = SoundRecipe::Kind::speech;
  recipe.utterances = {{0.3, "One two three."}, {2, "-- --help"}};  // words are never options
  std::vector<float> sound;
  try {
    sound = make_sound(recipe, 16000, 48000, 1);
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("espeak-ng"), std::string::npos);
    GTEST_SKIP() << error.what();
  }
  const auto active = activity_of(sound, 160, 16000);
  EXPECT_FALSE(active[20]);
  EXPECT_TRUE(active[60]);
  EXPECT_EQ(sound, make_sound(recipe, 16000, 48000, 1));
}

}  // namespace
}  // namespace odas::sound_test
