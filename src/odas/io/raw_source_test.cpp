// SPDX-License-Identifier: MIT
#include "odas/io/raw_source.hpp"

#include <thread>

#include "support/scratch.hpp"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "odas/base/error.hpp"

namespace odas::raw_source_test {
namespace {

RawConfig stereo() {
  RawConfig raw;
  raw.n_channels = 2;
  return raw;
}

/// Frames 0x0001/-1, 0x0002/-2, ... of 16 bits.
std::string frames(int count) {
  std::string bytes;
  for (int i = 1; i <= count; ++i) {
    for (const int value : {i, -i}) {
      bytes += static_cast<char>(value & 0xFF);
      bytes += static_cast<char>((value >> 8) & 0xFF);
    }
  }
  return bytes;
}

std::string error_of(const std::filesystem::path& file) {
  try {
    const RawSource source(file, stereo());
    return "";
  } catch (const IoError& error) { return error.what(); }
}

TEST(RawSource, reads_all_frames_and_then_the_end) {
  const test::Scratch scratch;
  test::write_file(scratch / "a.raw", frames(5));
  RawSource source(scratch / "a.raw", stereo());
  EXPECT_EQ(source.total_frames(), 5U);
  Grid<float> block(2, 3);
  ReadResult read = source.read(block);
  EXPECT_EQ(read.frames, 3U);
  EXPECT_FALSE(read.end);
  EXPECT_EQ(block[0][2], 3 / 32768.F);
  EXPECT_EQ(block[1][2], -3 / 32768.F);
  read = source.read(block);
  EXPECT_EQ(read.frames, 2U);
  EXPECT_TRUE(read.end);
  EXPECT_TRUE(read.status.ok());
  EXPECT_EQ(block[0][1], 5 / 32768.F);
  EXPECT_EQ(source.warning(), "");
}

TEST(RawSource, warns_of_a_torn_frame_at_the_end) {
  const test::Scratch scratch;
  test::write_file(scratch / "a.raw", frames(5) + "x");
  RawSource source(scratch / "a.raw", stereo());
  Grid<float> block(2, 100);
  EXPECT_EQ(source.read(block).frames, 5U);
  EXPECT_NE(source.warning().find("ends in the middle of a sample: 1 bytes are left over"),
            std::string::npos);
}

TEST(RawSource, says_what_is_wrong_with_a_file_that_cannot_be_read) {
  const test::Scratch scratch;
  test::write_file(scratch / "empty.raw", "");
  test::write_file(scratch / "tiny.raw", "abc");
  EXPECT_NE(error_of(scratch / "missing.raw").find("missing.raw: No such file or directory"),
            std::string::npos);
  EXPECT_NE(error_of(scratch / "empty.raw").find("is empty"), std::string::npos);
  EXPECT_NE(error_of(scratch / "tiny.raw").find("holds less than one sample of 2 channels of S16_LE"),
            std::string::npos);
  EXPECT_NE(error_of(scratch.folder()).find("it is a folder"), std::string::npos);
}

TEST(RawSource, of_a_silent_pipe_gives_nothing_for_now_and_stays_able_to_stop) {
  const test::Scratch scratch;
  const auto pipe = scratch / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  FileDescriptor writer(::open(pipe.c_str(), O_RDWR));
  RawSource source(pipe, stereo());
  Grid<float> block(2, 3);
  ReadResult read = source.read(block);
  EXPECT_EQ(read.frames, 0U);
  EXPECT_FALSE(read.end);

  const std::string bytes = frames(3);
  ASSERT_EQ(::write(writer.get(), bytes.data(), 5), 5) << "a frame and a bit";
  EXPECT_EQ(source.read(block).frames, 0U) << "not a whole block yet";
  ASSERT_EQ(::write(writer.get(), bytes.data() + 5, bytes.size() - 5),
            static_cast<ssize_t>(bytes.size() - 5));
  read = source.read(block);
  EXPECT_EQ(read.frames, 3U) << "none is lost";
  EXPECT_EQ(block[1][2], -3 / 32768.F);
}

}  // namespace
}  // namespace odas::raw_source_test
