// SPDX-License-Identifier: MIT
#include "odas/io/pcm.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::pcm_test {
namespace {

constexpr int kBits[] = {8, 16, 24, 32};

std::vector<char> encoded(const Grid<float>& block, int bits, float gain = 1, std::uint64_t* held = nullptr) {
  std::vector<char> bytes(block.rows() * block.cols() * pcm_bytes(bits));
  const std::uint64_t count = encode_pcm(block, gain, bits, bytes);
  if (held != nullptr) *held = count;
  return bytes;
}

/// One sample, as the integer that its bytes are.
std::int64_t sample(float x, int bits, std::uint64_t* held = nullptr) {
  Grid<float> block(1, 1);
  block[0][0] = x;
  const std::vector<char> bytes = encoded(block, bits, 1, held);
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data(), bytes.size());
  const int shift = 32 - bits;
  return static_cast<std::int32_t>(value << shift) >> shift;
}

TEST(Pcm, holds_what_is_too_loud_at_full_scale_where_odas_wrapped) {
  for (const int bits : kBits) {
    const std::int64_t full = std::int64_t{1} << (bits - 1);
    for (const float loud : {1.F, 1.5F, 100.F, 3e38F, std::numeric_limits<float>::infinity()}) {
      std::uint64_t held = 0;
      EXPECT_EQ(sample(loud, bits, &held), full - 1) << bits << " bits, " << loud;
      EXPECT_EQ(held, 1U);
      EXPECT_EQ(sample(-loud, bits, &held), -full) << bits << " bits, " << -loud;
      EXPECT_EQ(held, loud == 1 ? 0U : 1U) << "-1 is within";
    }
  }
  EXPECT_EQ(sample(0.99999F, 16), 32767) << "ODAS wrote -32768";
}

TEST(Pcm, writes_something_defined_for_what_is_no_number) {
  for (const int bits : kBits) {
    const std::int64_t value = sample(std::numeric_limits<float>::quiet_NaN(), bits);
    EXPECT_GE(value, -(std::int64_t{1} << (bits - 1)));
  }
}

RC_GTEST_PROP(Pcm, rounds_half_away_from_zero_as_odas, ()) {
  const float x = static_cast<float>(*rc::gen::inRange(-2000000, 2000000)) / 2000001.F;
  for (const int bits : {8, 16, 24}) {
    const double scaled = std::round(static_cast<double>(x) * std::ldexp(1.0, bits - 1));
    RC_ASSERT(sample(x, bits) == static_cast<std::int64_t>(std::min(scaled, std::ldexp(1.0, bits - 1) - 1)));
  }
}

TEST(Pcm, rounds_the_hard_cases) {
  EXPECT_EQ(sample(0.5F / 32768, 16), 1);
  EXPECT_EQ(sample(-0.5F / 32768, 16), -1);
  EXPECT_EQ(sample(0.49999997F / 32768, 16), 0);
  EXPECT_EQ(sample(1.5F / 32768, 16), 2);
  EXPECT_EQ(sample(-2.5F / 32768, 16), -3);
}

RC_GTEST_PROP(Pcm, decoding_is_the_inverse_of_encoding, ()) {
  const auto channels = *rc::gen::inRange<std::size_t>(1, 6);
  const auto frames = *rc::gen::inRange<std::size_t>(1, 300);
  const int bits = *rc::gen::elementOf(std::vector<int>{8, 16, 24});
  Grid<float> block(channels, frames);
  const auto full = 1 << (bits - 1);
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < frames; ++i) {
      const auto value =
          static_cast<int>((i * 7919 + c * 104729) % static_cast<std::size_t>(2 * full)) - full;
      block[c][i] = static_cast<float>(value) / static_cast<float>(full);
    }
  }
  Grid<float> back(channels, frames);
  decode_pcm(encoded(block, bits), bits, back);
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < frames; ++i) RC_ASSERT(back[c][i] == block[c][i]);
  }
}

TEST(Pcm, is_little_endian_and_interleaved) {
  Grid<float> block(2, 2);
  block[0][0] = 0x0102 / 32768.F;
  block[1][0] = -1;
  block[0][1] = 0x0304 / 32768.F;
  const std::vector<char> bytes = encoded(block, 16);
  EXPECT_EQ(bytes, (std::vector<char>{2, 1, 0, '\x80', 4, 3, 0, 0}));
}

TEST(Pcm, decodes_the_ends_of_each_range) {
  const std::vector<char> lowest{0, 0, 0, '\x80'};
  const std::vector<char> highest{'\xFF', '\xFF', '\xFF', '\x7F'};
  for (const int bits : kBits) {
    Grid<float> block(1, 1);
    const std::size_t size = pcm_bytes(bits);
    decode_pcm(std::span(lowest).last(size), bits, block);
    EXPECT_EQ(block[0][0], -1) << bits;
    decode_pcm(std::span(highest).last(size), bits, block);
    EXPECT_NEAR(block[0][0], 1 - std::ldexp(1.0, 1 - bits), 1e-7) << bits;
  }
}

TEST(Pcm, applies_the_gain_before_it_holds) {
  Grid<float> block(1, 3);
  block[0][0] = 0.05F;
  block[0][1] = 0.2F;
  block[0][2] = -0.2F;
  std::uint64_t held = 0;
  std::vector<char> bytes = encoded(block, 16, 10, &held);
  EXPECT_EQ(held, 2U);
  std::int16_t first = 0;
  std::memcpy(&first, bytes.data(), 2);
  EXPECT_EQ(first, 16384);
}

}  // namespace
}  // namespace odas::pcm_test
