// SPDX-License-Identifier: MIT
#include "odas/io/mono_wav.hpp"

#include <array>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

fs::path temporary(const char* name) { return fs::path(testing::TempDir()) / name; }

TEST(MonoWav, clips_what_is_louder_than_full_scale) {
  const fs::path file = temporary("odas_mono_clip.wav");
  MonoWav wav(file, 16000);
  wav.write(std::array{0.5F, 1.5F, -1.5F, -0.25F});
  wav.close();
  SndfileHandle read(file.string());
  ASSERT_EQ(read.frames(), 4);
  EXPECT_EQ(read.channels(), 1);
  EXPECT_EQ(read.samplerate(), 16000);
  std::array<short, 4> samples{};
  read.readf(samples.data(), 4);
  EXPECT_NEAR(samples[0], 16384, 1);
  EXPECT_EQ(samples[1], 32767);
  EXPECT_EQ(samples[2], -32768);
  EXPECT_NEAR(samples[3], -8192, 1);
  fs::remove(file);
}

TEST(MonoWav, is_whole_when_it_is_dropped_without_being_closed) {
  const fs::path file = temporary("odas_mono_drop.wav");
  {
    MonoWav wav(file, 48000);
    wav.write(std::vector<float>(1000, 0.1F));
  }
  EXPECT_EQ(SndfileHandle(file.string()).frames(), 1000);
  fs::remove(file);
}

TEST(MonoWav, names_the_file_that_it_cannot_write) {
  const fs::path file = temporary("no_such_folder") / "a.wav";
  try {
    const MonoWav wav(file, 16000);
    FAIL() << "opened a file in a folder that is not there";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
  }
}

TEST(MonoWav, says_that_the_disk_is_full) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto write_much = [] {
    MonoWav wav("/dev/full", 16000);
    for (int i = 0; i < 100; ++i) wav.write(std::vector<float>(16000, 0.1F));
    wav.close();
  };
  EXPECT_THROW(write_much(), IoError);
}

}  // namespace
}  // namespace odas
