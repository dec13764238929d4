// SPDX-License-Identifier: MIT
#include "odas/studio/crc32.hpp"

#include <array>
#include <bit>
#include <cstring>

namespace odas {
namespace {

static_assert(std::endian::native == std::endian::little, "eight bytes are read as they lie in memory");

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
    tables[0][byte] = sum;
  }
  for (std::size_t t = 1; t < tables.size(); ++t) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[t - 1][byte];
      tables[t][byte] = (before >> 8) ^ tables[0][before & 0xFFU];
    }
  }
  return tables;
}

constexpr Tables kTables = make_tables();

}  // namespace

void Crc32::add(std::span<const char> bytes) noexcept {
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, bytes.data(), sizeof eight);
    eight ^= state_;
    state_ = 0;
    for (std::size_t i = 0; i < 8; ++i) state_ ^= kTables[7 - i][(eight >> (8 * i)) & 0xFFU];
  }
  for (const char byte : bytes) {
    state_ = (state_ >> 8) ^ kTables[0][(state_ ^ static_cast<std::uint8_t>(byte)) & 0xFFU];
  }
}

}  // namespace odas
