// SPDX-License-Identifier: MIT
#include "odas/io/pcm.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace odas {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are copied as they lie in memory");

template <int Bits>
std::int32_t load(const char* from) noexcept {
  if constexpr (Bits == 8) return static_cast<signed char>(*from);
  if constexpr (Bits == 16) {
    std::int16_t value = 0;
    std::memcpy(&value, from, sizeof value);
    return value;
  }
  if constexpr (Bits == 24) {
    std::uint32_t value = 0;
    std::memcpy(&value, from, 3);
    return static_cast<std::int32_t>(value << 8) >> 8;
  }
  std::int32_t value = 0;
  if constexpr (Bits == 32) std::memcpy(&value, from, sizeof value);
  return value;
}

template <int Bits>
void decode(const char* bytes, GridView<float> block) noexcept {
  constexpr std::size_t kSize = pcm_bytes(Bits);
  constexpr float kScale = 1 / static_cast<float>(std::int64_t{1} << (Bits - 1));
  const std::size_t step = block.rows() * kSize;
  for (std::size_t c = 0; c < block.rows(); ++c) {
    const char* from = bytes + c * kSize;
    for (float& x : block[c]) {
      x = static_cast<float>(load<Bits>(from)) * kScale;
      from += step;
    }
  }
}

/// Rounds half away from zero, as roundf, but without a call: the largest float under one half, so that
/// 0.49999997 is not lifted to 1.
std::int32_t round_away(float value) noexcept {
  return static_cast<std::int32_t>(value + std::copysign(0.49999997F, value));
}

constexpr std::size_t kChunk = 128;

/// At most kChunk samples to integers. 8 to 24 bits are exact in float.
template <int Bits>
std::uint32_t quantise(std::span<const float> samples, float gain, std::int32_t* values) noexcept {
  constexpr auto kFull = static_cast<float>(1 << (Bits - 1));
  std::uint32_t held = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float x = samples[i] * gain * kFull;
    held += static_cast<std::uint32_t>(x >= kFull - 0.5F) | static_cast<std::uint32_t>(x < -kFull);
    const float above = x > -kFull ? x : -kFull;  // so that NaN is held too
    values[i] = round_away(above < kFull - 1 ? above : kFull - 1);
  }
  return held;
}

template <>
std::uint32_t quantise<32>(std::span<const float> samples, float gain, std::int32_t* values) noexcept {
  constexpr double kFull = 2147483648.0;
  std::uint32_t held = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double x = static_cast<double>(samples[i] * gain) * kFull;
    held += static_cast<std::uint32_t>(x >= kFull - 0.5) | static_cast<std::uint32_t>(x < -kFull);
    const double above = x > -kFull ? x : -kFull;
    const double within = above < kFull - 1 ? above : kFull - 1;
    values[i] = static_cast<std::int32_t>(within + std::copysign(0.5, within));
  }
  return held;
}

template <int Bits>
std::uint64_t encode(GridView<const float> block, float gain, char* bytes) noexcept {
  constexpr std::size_t kSize = pcm_bytes(Bits);
  const std::size_t step = block.rows() * kSize;
  std::array<std::int32_t, kChunk> values;
  std::uint64_t held = 0;
  for (std::size_t c = 0; c < block.rows(); ++c) {
    char* to = bytes + c * kSize;
    for (std::size_t at = 0; at < block.cols(); at += kChunk) {
      const std::size_t n = std::min(kChunk, block.cols() - at);
      held += quantise<Bits>(block[c].subspan(at, n), gain, values.data());
      for (std::size_t i = 0; i < n; ++i) {
        std::memcpy(to, &values[i], kSize);
        to += step;
      }
    }
  }
  return held;
}

}  // namespace

void decode_pcm(std::span<const char> bytes, int bits, GridView<float> block) noexcept {
  ODAS_EXPECT(bytes.size() == block.rows() * block.cols() * pcm_bytes(bits));
  if (bits == 8) decode<8>(bytes.data(), block);
  if (bits == 16) decode<16>(bytes.data(), block);
  if (bits == 24) decode<24>(bytes.data(), block);
  if (bits == 32) decode<32>(bytes.data(), block);
}

std::uint64_t encode_pcm(GridView<const float> block, float gain, int bits, std::span<char> bytes) noexcept {
  ODAS_EXPECT(bytes.size() == block.rows() * block.cols() * pcm_bytes(bits));
  if (bits == 8) return encode<8>(block, gain, bytes.data());
  if (bits == 16) return encode<16>(block, gain, bytes.data());
  if (bits == 24) return encode<24>(block, gain, bytes.data());
  return encode<32>(block, gain, bytes.data());
}

}  // namespace odas
