// SPDX-License-Identifier: MIT
// The forms that samples have on devices, in streams and in headerless files: little-endian, channels
// interleaved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "odas/base/grid.hpp"
#include "odas/engine/config.hpp"

namespace odas {

/// By ALSA's names. The best first, where a device offers several.
enum class SampleFormat : std::uint8_t {
  s32,    // S32_LE
  s24_3,  // S24_3LE: 24 bits in 3 bytes
  s24,    // S24_LE: 24 bits in the low 3 of 4 bytes
  f32,    // FLOAT_LE: full scale 1
  s16,    // S16_LE
  s8,     // S8
  u8,     // U8: 128 is silence
};
inline constexpr std::size_t kSampleFormats = 7;

[[nodiscard]] std::string_view name_of(SampleFormat format) noexcept;
[[nodiscard]] std::optional<SampleFormat> sample_format(std::string_view name) noexcept;

[[nodiscard]] std::size_t bytes_of(SampleFormat format) noexcept;
/// `raw.nBits` of a sample: what it can tell apart. 32 for floats.
[[nodiscard]] int bits_of(SampleFormat format) noexcept;

/// The format of what has no say of its own, a headerless file or a stream: `raw.format`, or, where it is
/// absent or "auto", the signed and packed one of `raw.nBits`.
[[nodiscard]] SampleFormat stream_format(const RawConfig& raw) noexcept;

/// Bytes [frame][channel] -> `block` [channel][frame], full scale 1. `bytes` holds exactly the block. Floats
/// are taken as they are: they may be infinite or no numbers.
void decode_samples(std::span<const char> bytes, SampleFormat format, GridView<float> block) noexcept;

}  // namespace odas
