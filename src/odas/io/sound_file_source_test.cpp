// SPDX-License-Identifier: MIT
#include "odas/io/sound_file_source.hpp"

#include <cmath>
#include <limits>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.h>

#include "odas/base/error.hpp"

namespace odas::sound_file_source_test {
namespace {

/// Two channels at 16 kHz of noise, the second one negative.
void write_sound(const std::filesystem::path& file, int format, int frames) {
  SF_INFO info{};
  info.samplerate = 16000;
  info.channels = 2;
  info.format = format;
  SNDFILE* sound = sf_open(file.c_str(), SFM_WRITE, &info);
  ASSERT_NE(sound, nullptr);
  std::vector<short> samples;
  for (int i = 0; i < frames; ++i) {
    const auto x = static_cast<short>(i * 7919 % 30011 - 15000);
    samples.push_back(x);
    samples.push_back(static_cast<short>(-x));
  }
  sf_writef_short(sound, samples.data(), frames);
  sf_close(sound);
}

std::size_t read_all(SoundFileSource& source) {
  Grid<float> block(2, 1000);
  for (std::size_t frames = 0;;) {
    const ReadResult read = source.read(block);
    EXPECT_TRUE(read.status.ok()) << read.status.what();
    frames += read.frames;
    if (read.end) return frames;
  }
}

void cut(const std::filesystem::path& file, double share) {
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  std::filesystem::resize_file(file, static_cast<std::uintmax_t>(size * share));
}

class SoundFileOf : public testing::TestWithParam<int> {};

TEST_P(SoundFileOf, reads_the_very_samples) {
  const test::Scratch scratch;
  write_sound(scratch / "a", GetParam(), 2500);
  SoundFileSource source(scratch / "a");
  EXPECT_EQ(source.channels(), 2U);
  EXPECT_EQ(source.sample_rate(), 16000);
  EXPECT_EQ(source.total_frames(), 2500U);
  Grid<float> block(2, 1000);
  EXPECT_EQ(source.read(block).frames, 1000U);
  EXPECT_EQ(block[0][3], (3 * 7919 % 30011 - 15000) / 32768.F);
  EXPECT_EQ(block[1][3], -block[0][3]);
  EXPECT_EQ(read_all(source), 1500U);
  EXPECT_EQ(source.warning(), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, SoundFileOf,
                         testing::Values(SF_FORMAT_WAV | SF_FORMAT_PCM_16, SF_FORMAT_WAV | SF_FORMAT_PCM_24,
                                         SF_FORMAT_FLAC | SF_FORMAT_PCM_16,
                                         SF_FORMAT_WAVEX | SF_FORMAT_PCM_16));

TEST(SoundFileSource, warns_of_a_wav_that_was_cut_and_gives_what_there_is) {
  const test::Scratch scratch;
  for (const int format : {SF_FORMAT_WAV | SF_FORMAT_PCM_16, SF_FORMAT_WAVEX | SF_FORMAT_PCM_24}) {
    write_sound(scratch / "a.wav", format, 32000);
    cut(scratch / "a.wav", 0.6);
    SoundFileSource source(scratch / "a.wav");
    EXPECT_NEAR(static_cast<double>(read_all(source)), 0.6 * 32000, 30);
    EXPECT_EQ(source.warning(),
              (scratch / "a.wav").string() +
                  " ends early, after 1.2 s of 2.0 s that its header speaks of: it was cut");
  }
}

TEST(SoundFileSource, fails_on_a_flac_that_was_cut_after_giving_what_there_is) {
  const test::Scratch scratch;
  for (const double share : {0.3, 0.5, 0.7, 0.9}) {
    write_sound(scratch / "a.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 32000);
    cut(scratch / "a.flac", share);
    SoundFileSource source(scratch / "a.flac");
    Grid<float> block(2, 1000);
    ReadResult read;
    std::size_t frames = 0;
    while (!read.end) {
      read = source.read(block);
      frames += read.frames;
    }
    EXPECT_GT(frames, 4000U) << share;
    EXPECT_NE(read.status.what().find("s of 2.0 s: it is cut or damaged"), std::string::npos)
        << read.status.what();
    EXPECT_EQ(source.warning(), "") << "it is said once";
  }
}

TEST(SoundFileSource, gives_what_is_not_finite_as_it_is_for_the_engine_to_count) {
  const test::Scratch scratch;
  SF_INFO info{};
  info.samplerate = 16000;
  info.channels = 2;
  info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* sound = sf_open((scratch / "a.wav").c_str(), SFM_WRITE, &info);
  const float samples[4] = {std::numeric_limits<float>::quiet_NaN(), 0.5F,
                            std::numeric_limits<float>::infinity(), 0.25F};
  sf_writef_float(sound, samples, 2);
  sf_close(sound);
  SoundFileSource source(scratch / "a.wav");
  Grid<float> block(2, 2);
  EXPECT_EQ(source.read(block).frames, 2U);
  EXPECT_TRUE(std::isnan(block[0][0]));
  EXPECT_TRUE(std::isinf(block[0][1]));
  EXPECT_EQ(block[1][1], 0.25F);
}

TEST(SoundFileSource, says_what_is_wrong) {
  const test::Scratch scratch;
  write_sound(scratch / "empty.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 0);
  test::write_file(scratch / "no.wav", "RIFF1234WAVEjunk");
  for (const char* name : {"missing.wav", "empty.wav", "no.wav"}) {
    try {
      const SoundFileSource source(scratch / name);
      ADD_FAILURE() << name;
    } catch (const IoError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace odas::sound_file_source_test
