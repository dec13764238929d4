// SPDX-License-Identifier: MIT
#include "odas/io/recording.hpp"

#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas::recording_test {
namespace {

RawConfig mono() {
  RawConfig raw;
  raw.n_channels = 1;
  return raw;
}

void write_wav(const std::filesystem::path& file, int rate = 16000, std::size_t channels = 1) {
  WavWriter writer(file, {rate, channels, 16});
  EXPECT_TRUE(writer.write(std::string(200 * channels, '\x10')).ok());
  EXPECT_TRUE(writer.close().ok());
}

std::string error_of(const std::filesystem::path& file) {
  try {
    static_cast<void>(open_recording(file, mono()));
    return "";
  } catch (const IoError& error) { return error.what(); }
}

TEST(OpenRecording, knows_a_wav_by_its_header_whatever_its_name) {
  const test::Scratch scratch;
  write_wav(scratch / "sound");
  write_wav(scratch / "sound.dat");
  for (const char* name : {"sound", "sound.dat"}) {
    EXPECT_EQ(open_recording(scratch / name, mono())->total_frames(), 100U) << name;
  }
}

TEST(OpenRecording, reads_all_else_as_headerless) {
  const test::Scratch scratch;
  test::write_file(scratch / "sound.bin", std::string(200, 'x'));
  EXPECT_EQ(open_recording(scratch / "sound.bin", mono())->total_frames(), 100U);
}

TEST(OpenRecording, never_misreads_a_headerless_file_that_begins_like_another) {
  const test::Scratch scratch;
  for (const char* head : {"fLaC", "OggS", ".snd", "caff", "RIFF1234WAVE"}) {
    test::write_file(scratch / "a.raw", head + std::string(400, 'x'));
    EXPECT_EQ(open_recording(scratch / "a.raw", mono())->total_frames(),
              std::filesystem::file_size(scratch / "a.raw") / 2)
        << head;
  }
  test::write_file(scratch / "riff", "RIFF" + std::string(400, 'x'));
  EXPECT_EQ(open_recording(scratch / "riff", mono())->total_frames(), 202U) << "RIFF alone is no WAV";
}

TEST(OpenRecording, refuses_a_recording_of_another_rate_or_array) {
  const test::Scratch scratch;
  write_wav(scratch / "rate.wav", 44100);
  write_wav(scratch / "channels.wav", 16000, 3);
  EXPECT_NE(error_of(scratch / "rate.wav").find("has 44100 Hz, but raw.fS is 16000"), std::string::npos);
  EXPECT_NE(error_of(scratch / "channels.wav").find("has 3 channels, but raw.nChannels is 1"),
            std::string::npos);
}

TEST(OpenRecording, does_not_play_a_broken_wav_as_noise) {
  const test::Scratch scratch;
  test::write_file(scratch / "broken.wav", std::string(1000, 'x'));
  EXPECT_NE(error_of(scratch / "broken.wav").find("is no sound file, though its name ends in .wav"),
            std::string::npos);
}

TEST(OpenRecording, says_that_a_file_is_missing_or_empty) {
  const test::Scratch scratch;
  test::write_file(scratch / "empty.wav", "");
  EXPECT_NE(error_of(scratch / "missing.wav").find("No such file"), std::string::npos);
  EXPECT_NE(error_of(scratch / "empty.wav").find("is empty"), std::string::npos);
}

}  // namespace
}  // namespace odas::recording_test
