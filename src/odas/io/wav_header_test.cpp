// SPDX-License-Identifier: MIT
#include "odas/io/wav_header.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::wav_header_test {
namespace {

std::string number(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xFF);
  return text;
}

std::string format_chunk(unsigned coding, unsigned channels, unsigned rate, unsigned bits) {
  return "fmt " + number(16, 4) + number(coding, 2) + number(channels, 2) + number(rate, 4) +
         number(rate * channels * bits / 8, 4) + number(channels * bits / 8, 2) + number(bits, 2);
}
std::string wav(const std::string& chunks, const std::string& magic = "RIFF") {
  return magic + number(0, 4) + "WAVE" + chunks;
}
std::string data(std::uint64_t size) { return "data" + number(size, 4); }

WavHeader read(const std::string& text, std::size_t step = 1, std::size_t* used = nullptr) {
  WavHeader header;
  std::size_t taken = 0;
  while (taken < text.size() && header.state() == WavHeader::State::undecided) {
    taken += header.push(std::span(text).subspan(taken, std::min(step, text.size() - taken)));
  }
  if (used != nullptr) *used = taken;
  return header;
}

TEST(WavHeader, is_read_however_it_is_cut) {
  const std::string text = wav(format_chunk(1, 8, 48000, 24) + "LIST" + number(5, 4) + "hello!" + data(4800));
  for (std::size_t step = 1; step < 40; ++step) {
    std::size_t used = 0;
    const WavHeader header = read(text + "samples", step, &used);
    ASSERT_EQ(header.state(), WavHeader::State::samples) << step;
    EXPECT_EQ(used, text.size()) << "not a byte of the samples";
    EXPECT_EQ(header.format().samples, SampleFormat::s24_3);
    EXPECT_EQ(header.format().channels, 8U);
    EXPECT_EQ(header.format().sample_rate, 48000);
    EXPECT_EQ(header.format().bytes, 4800U);
  }
}

TEST(WavHeader, knows_integers_floats_and_the_long_form) {
  EXPECT_EQ(read(wav(format_chunk(1, 1, 8000, 8) + data(1))).format().samples, SampleFormat::u8);
  EXPECT_EQ(read(wav(format_chunk(1, 1, 8000, 16) + data(1))).format().samples, SampleFormat::s16);
  EXPECT_EQ(read(wav(format_chunk(1, 1, 8000, 32) + data(1))).format().samples, SampleFormat::s32);
  EXPECT_EQ(read(wav(format_chunk(3, 1, 8000, 32) + data(1))).format().samples, SampleFormat::f32);
  std::string extensible = format_chunk(0xFFFE, 1, 8000, 32);
  extensible.replace(4, 4, number(40, 4));
  extensible += number(22, 2) + number(32, 2) + number(0, 4) + number(3, 2) + std::string(14, 'x');
  EXPECT_EQ(read(wav(extensible + data(1))).format().samples, SampleFormat::f32);
}

TEST(WavHeader, takes_a_size_that_nobody_knew_for_endless) {
  for (const std::uint64_t size : {0ULL, 0xFFFFFFFFULL, 0x7FFFFFFFULL, 0x7FFFFF00ULL}) {
    EXPECT_EQ(read(wav(format_chunk(1, 1, 8000, 16) + data(size))).format().bytes, WavHeader::kEndless);
  }
  const std::string long_size =
      "ds64" + number(28, 4) + number(9, 8) + number(5000000000, 8) + std::string(12, 0);
  EXPECT_EQ(read(wav(long_size + format_chunk(1, 1, 8000, 16) + data(0xFFFFFFFF), "RF64")).format().bytes,
            5000000000U);
}

TEST(WavHeader, gives_back_what_was_no_header) {
  for (const char* text : {"samples", "RIFx", "RIFF1234WAVx", "RF63", "fLaD"}) {
    const std::string bytes = text;
    std::size_t used = 0;
    const WavHeader header = read(bytes, 100, &used);
    ASSERT_EQ(header.state(), WavHeader::State::headerless) << text;
    EXPECT_EQ(std::string(header.taken().begin(), header.taken().end()), bytes.substr(0, used));
  }
}

TEST(WavHeader, says_what_it_cannot_read) {
  EXPECT_NE(read("fLaC....").fault().find("flac -dc"), std::string::npos);
  EXPECT_NE(read(wav(format_chunk(17, 1, 8000, 4) + data(1))).fault().find("coding 17 with 4 bits"),
            std::string::npos);
  EXPECT_NE(read(wav(data(1))).fault().find("without a format"), std::string::npos);
}

RC_GTEST_PROP(WavHeader, survives_anything_that_begins_like_one, (const std::string& rest)) {
  const WavHeader header = read(wav("fmt " + rest), 7);
  RC_ASSERT(header.state() != WavHeader::State::headerless);
}

}  // namespace
}  // namespace odas::wav_header_test
