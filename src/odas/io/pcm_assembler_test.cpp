// SPDX-License-Identifier: MIT
#include "odas/io/pcm_assembler.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::pcm_assembler_test {
namespace {

/// Samples 0, 1, 2, ... of 16 bits, channel after channel.
std::string counting(int samples) {
  std::string bytes;
  for (int i = 0; i < samples; ++i) {
    bytes += static_cast<char>(i & 0xFF);
    bytes += static_cast<char>(i >> 8);
  }
  return bytes;
}

std::string wav_header(char channels, const std::string& size = std::string("\xFF\xFF\xFF\xFF", 4)) {
  return "RIFF" + std::string(4, 0) + "WAVEfmt " + std::string("\x10\0\0\0\1\0", 6) + channels +
         std::string("\0\x80\x3E\0\0....", 9) + std::string("\6\0\x10\0", 4) + "data" + size;
}

/// All that comes out, in order, where chunks of `size(n)` bytes go in.
template <class Size>
std::vector<float> frames_of(PcmAssembler& assembler, const std::string& bytes, Size size) {
  std::vector<float> all;
  Grid<float> block(3, 7);
  for (std::size_t at = 0; at < bytes.size();) {
    at += assembler.push(std::span(bytes).subspan(at, std::min(size(), bytes.size() - at)));
    while (const std::size_t n = assembler.pop(block)) {
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < 3; ++c) all.push_back(block[c][i] * 32768);
      }
    }
  }
  return all;
}

const PcmAssembler::Expected kThree{SampleFormat::s16, 3, 16000};

RC_GTEST_PROP(PcmAssembler, never_slips_a_channel_however_the_bytes_are_cut, ()) {
  PcmAssembler assembler(kThree, 20);
  const int samples = *rc::gen::inRange(0, 600);
  const bool header = *rc::gen::arbitrary<bool>();
  const auto sizes =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 200)));
  std::size_t turn = 0;
  const std::vector<float> all = frames_of(assembler, (header ? wav_header(3) : "") + counting(samples),
                                           [&] { return sizes[turn++ % sizes.size()]; });
  RC_ASSERT(all.size() == static_cast<std::size_t>(samples / 3 * 3));
  for (std::size_t i = 0; i < all.size(); ++i) RC_ASSERT(all[i] == static_cast<float>(i));
  RC_ASSERT(assembler.finish() == static_cast<std::size_t>(samples % 3 * 2));
}

TEST(PcmAssembler, holds_the_sender_back_when_it_is_full) {
  PcmAssembler assembler(kThree, 20);
  const std::string bytes = counting(3000);
  const std::size_t taken = assembler.push(bytes);
  EXPECT_LT(taken, 40U * 6);
  EXPECT_GE(assembler.frames(), 20U);
  EXPECT_EQ(assembler.push(std::span(bytes).subspan(taken)), 0U);
}

TEST(PcmAssembler, begins_anew_with_another_stream_after_one_that_broke_off) {
  PcmAssembler assembler(kThree, 20);
  EXPECT_EQ(assembler.push(counting(7)), 14U);
  EXPECT_EQ(assembler.finish(), 2U);
  EXPECT_EQ(assembler.push(counting(3)), 6U);
  Grid<float> block(3, 10);
  ASSERT_EQ(assembler.pop(block), 3U);
  EXPECT_EQ(block[0][2], 0.0F);
  EXPECT_EQ(block[2][2], 2 / 32768.0F) << "in step again";
}

TEST(PcmAssembler, ends_with_the_samples_of_a_wav) {
  PcmAssembler assembler(kThree, 20);
  EXPECT_EQ(assembler.push(wav_header(3, std::string("\x0C\0\0\0", 4)) + counting(6) + "LISTtail"),
            44U + 20U);
  EXPECT_TRUE(assembler.over());
  EXPECT_EQ(assembler.frames(), 2U);
}

TEST(PcmAssembler, says_what_does_not_fit) {
  PcmAssembler channels(kThree, 20);
  channels.push(wav_header(4));
  EXPECT_EQ(channels.fault(), "has 4 channels, but raw.nChannels is 3");
  PcmAssembler rate({SampleFormat::s16, 3, 48000}, 20);
  rate.push(wav_header(3));
  EXPECT_EQ(rate.fault(), "has 16000 Hz, but raw.fS is 48000");
  EXPECT_EQ(rate.frames(), 0U);
}

TEST(PcmAssembler, takes_a_stream_of_a_few_bytes_for_samples) {
  PcmAssembler assembler({SampleFormat::s8, 1, 16000}, 20);
  assembler.push(std::string("RIFF"));
  EXPECT_EQ(assembler.frames(), 0U) << "it could be a WAV";
  EXPECT_EQ(assembler.finish(), 0U);
  EXPECT_EQ(assembler.frames(), 4U);
}

RC_GTEST_PROP(PcmAssembler, takes_garbage_in_every_format, (const std::string& garbage)) {
  for (std::size_t f = 0; f < kSampleFormats; ++f) {
    PcmAssembler assembler({static_cast<SampleFormat>(f), 2, 16000}, 5);
    Grid<float> block(2, 5);
    for (std::size_t at = 0; at < garbage.size();) {
      at += assembler.push(std::span(garbage).subspan(at));
      RC_ASSERT(assembler.frames() <= 5 + WavHeader::kMagic);
      while (assembler.pop(block) > 0) {}
    }
  }
}

}  // namespace
}  // namespace odas::pcm_assembler_test
