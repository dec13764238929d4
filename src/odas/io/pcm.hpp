// SPDX-License-Identifier: MIT
// Integer samples as bytes: signed, little-endian, packed in nBits/8 bytes, the channels interleaved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "odas/base/grid.hpp"

namespace odas {

/// Bytes of a sample of 8, 16, 24 or 32 bits.
[[nodiscard]] constexpr std::size_t pcm_bytes(int bits) noexcept {
  return static_cast<std::size_t>(bits) / 8;
}

/// Bytes [frame][channel] -> `block` [channel][frame], full scale 1. `bytes` holds exactly the block.
void decode_pcm(std::span<const char> bytes, int bits, GridView<float> block) noexcept;

/// `block` [channel][frame], times `gain`, -> bytes [frame][channel]: value = round(x * 2^(bits-1)), held at
/// full scale (ODAS let it wrap). `bytes` holds exactly the block. Returns how many samples were held.
std::uint64_t encode_pcm(GridView<const float> block, float gain, int bits, std::span<char> bytes) noexcept;

}  // namespace odas
