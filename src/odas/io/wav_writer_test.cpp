// SPDX-License-Identifier: MIT
#include "odas/io/wav_writer.hpp"

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sndfile.h>

#include "odas/base/error.hpp"

namespace odas::wav_writer_test {
namespace {

/// What libsndfile reads of a file; frames = -1: it cannot.
SF_INFO read_info(const std::filesystem::path& file) {
  SF_INFO info{};
  SNDFILE* sound = sf_open(file.c_str(), SFM_READ, &info);
  if (sound == nullptr) info.frames = -1;
  sf_close(sound);
  return info;
}

const WavWriter::Format kStereo{44100, 2, 16};
const std::string kTenFrames(40, '\x11');

TEST(WavWriter, writes_what_others_read) {
  const test::Scratch scratch;
  for (const int bits : {8, 16, 24, 32}) {
    const auto file = scratch / (std::to_string(bits) + ".wav");
    WavWriter writer(file, {44100, 3, bits});
    EXPECT_TRUE(writer.write(std::string(static_cast<std::size_t>(30 * bits / 8), '\x11')).ok());
    EXPECT_TRUE(writer.close().ok());
    const SF_INFO info = read_info(file);
    EXPECT_EQ(info.frames, 10) << bits;
    EXPECT_EQ(info.channels, 3);
    EXPECT_EQ(info.samplerate, 44100);
    const int format = bits == 8    ? SF_FORMAT_PCM_U8
                       : bits == 16 ? SF_FORMAT_PCM_16
                       : bits == 24 ? SF_FORMAT_PCM_24
                                    : SF_FORMAT_PCM_32;
    EXPECT_EQ(info.format & SF_FORMAT_SUBMASK, format);
  }
}

TEST(WavWriter, is_valid_after_each_flush_should_the_program_be_killed) {
  const test::Scratch scratch;
  WavWriter writer(scratch / "a.wav", kStereo);
  EXPECT_EQ(read_info(scratch / "a.wav").frames, 0) << "from the start";
  for (int i = 1; i <= 3; ++i) {
    EXPECT_TRUE(writer.write(kTenFrames).ok());
    EXPECT_TRUE(writer.flush().ok());
    EXPECT_EQ(read_info(scratch / "a.wav").frames, 10 * i);
  }
}

TEST(WavWriter, is_valid_and_whole_where_the_disk_is_full) {
  const test::Scratch scratch;
  const test::FileSizeLimit limit(kWavHeaderSize + 100);
  WavWriter writer(scratch / "a.wav", kStereo);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(writer.write(kTenFrames).ok());
  EXPECT_FALSE(writer.close().ok());
  EXPECT_EQ(read_info(scratch / "a.wav").frames, 20) << "two records of 40 bytes, and not 25 frames";
  EXPECT_EQ(std::filesystem::file_size(scratch / "a.wav"), kWavHeaderSize + 80);
}

TEST(WavWriter, beyond_4_GiB_is_RF64) {
  const test::Scratch scratch;
  const std::uint64_t data = (std::uint64_t{5} << 30) + 4;  // bytes, of which the disk sees none
  for (const std::uint64_t size : {kWavHeaderSize + data, std::uint64_t{0x100000000 + 7}}) {
    const WavHeaderBytes header = wav_header(kStereo, size);
    test::write_file(scratch / "long.wav", {header.begin(), header.end()});
    std::filesystem::resize_file(scratch / "long.wav", size);
    const SF_INFO info = read_info(scratch / "long.wav");
    EXPECT_EQ(static_cast<std::uint64_t>(info.frames), (size - kWavHeaderSize) / 4);
    const bool large = size > 0x100000007;
    EXPECT_EQ(info.format & SF_FORMAT_TYPEMASK, large ? SF_FORMAT_RF64 : SF_FORMAT_WAV) << size;
  }
}

TEST(WavWriter, says_at_once_where_it_cannot_write) {
  const test::Scratch scratch;
  EXPECT_THROW(WavWriter(scratch / "missing/a.wav", kStereo), IoError);
  EXPECT_THROW(WavWriter("/dev/full", kStereo), IoError);
}

}  // namespace
}  // namespace odas::wav_writer_test
