// SPDX-License-Identifier: MIT
#include "odas/io/sample_format.hpp"

#include <cstring>

#include <gtest/gtest.h>

namespace odas::sample_format_test {
namespace {

constexpr SampleFormat kAll[] = {SampleFormat::s32, SampleFormat::s24_3, SampleFormat::s24, SampleFormat::f32,
                                 SampleFormat::s16, SampleFormat::s8,    SampleFormat::u8};

float sample(SampleFormat format, std::initializer_list<unsigned char> bytes) {
  std::vector<char> text(bytes.begin(), bytes.end());
  Grid<float> block(1, 1);
  decode_samples(text, format, block);
  return block[0][0];
}

TEST(SampleFormat, is_known_by_its_name_in_ALSA) {
  for (const SampleFormat format : kAll) EXPECT_EQ(sample_format(name_of(format)), format);
  EXPECT_EQ(sample_format("S16_BE"), std::nullopt);
  EXPECT_EQ(sample_format("auto"), std::nullopt);
  EXPECT_EQ(sample_format(""), std::nullopt);
}

TEST(SampleFormat, tells_both_packings_of_24_bits_apart) {
  EXPECT_EQ(sample(SampleFormat::s24_3, {0x00, 0x00, 0x40}), 0.5F);
  EXPECT_EQ(sample(SampleFormat::s24, {0x00, 0x00, 0x40, 0x00}), 0.5F);
  EXPECT_EQ(sample(SampleFormat::s24, {0x00, 0x00, 0xC0, 0xFF}), -0.5F);
  EXPECT_EQ(sample(SampleFormat::s24, {0x00, 0x00, 0xC0, 0x12}), -0.5F) << "the fourth byte is no part of it";
  EXPECT_EQ(sample(SampleFormat::s24_3, {0xFF, 0xFF, 0xFF}), -1.0F / 8388608);
  EXPECT_EQ(sample(SampleFormat::s24, {0xFF, 0xFF, 0xFF, 0xFF}), -1.0F / 8388608);
  EXPECT_EQ(bytes_of(SampleFormat::s24), 4U);
  EXPECT_EQ(bytes_of(SampleFormat::s24_3), 3U);
}

TEST(SampleFormat, reads_the_others) {
  EXPECT_EQ(sample(SampleFormat::s8, {0x80}), -1.0F);
  EXPECT_EQ(sample(SampleFormat::u8, {0x80}), 0.0F) << "ODAS took PulseAudio's unsigned bytes for signed";
  EXPECT_EQ(sample(SampleFormat::u8, {0x00}), -1.0F);
  EXPECT_EQ(sample(SampleFormat::u8, {0xFF}), 127.0F / 128);
  EXPECT_EQ(sample(SampleFormat::s16, {0x00, 0x40}), 0.5F);
  EXPECT_EQ(sample(SampleFormat::s32, {0x00, 0x00, 0x00, 0xC0}), -0.5F);
  EXPECT_EQ(sample(SampleFormat::f32, {0x00, 0x00, 0x80, 0xBE}), -0.25F);
}

TEST(SampleFormat, keeps_the_channels_apart) {
  for (const SampleFormat format : kAll) {
    std::vector<char> bytes(3 * 2 * bytes_of(format));
    const std::size_t size = bytes_of(format);
    for (std::size_t i = 0; i < 6; ++i) {
      const float value = static_cast<float>(i) / 8;
      if (format == SampleFormat::f32) {
        std::memcpy(bytes.data() + i * size, &value, size);
      } else {
        const auto high = static_cast<char>(i * 16 + (format == SampleFormat::u8 ? 128 : 0));
        bytes[i * size + std::min<std::size_t>(size, format == SampleFormat::s24 ? 3 : size) - 1] = high;
      }
    }
    Grid<float> block(2, 3);
    decode_samples(bytes, format, block);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(block[i % 2][i / 2], static_cast<float>(i) / 8) << name_of(format) << ' ' << i;
    }
  }
}

TEST(SampleFormat, of_a_stream_follows_nBits_unless_it_is_said) {
  RawConfig raw;
  for (const auto& [bits, format] : {std::pair{8, SampleFormat::s8}, std::pair{16, SampleFormat::s16},
                                     std::pair{24, SampleFormat::s24_3}, std::pair{32, SampleFormat::s32}}) {
    raw.n_bits = bits;
    EXPECT_EQ(stream_format(raw), format);
  }
  raw.format = "auto";
  EXPECT_EQ(stream_format(raw), SampleFormat::s32) << "a stream cannot be asked";
  raw.format = "S24_LE";
  EXPECT_EQ(stream_format(raw), SampleFormat::s24);
}

}  // namespace
}  // namespace odas::sample_format_test
