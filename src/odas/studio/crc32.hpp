// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace odas {

/// The check sum of ZIP and MCAP, over bytes that come in pieces.
/// Source: ISO 3309, polynomial 0xEDB88320 reflected; eight bytes at a time, as Kounavis and Berry,
/// "A systematic approach to building high performance software-based CRC generators", ISCC 2005.
class Crc32 {
 public:
  void add(std::span<const char> bytes) noexcept;
  [[nodiscard]] std::uint32_t value() const noexcept { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFFU;
};

[[nodiscard]] inline std::uint32_t crc32_of(std::span<const char> bytes) noexcept {
  Crc32 sum;
  sum.add(bytes);
  return sum.value();
}

}  // namespace odas
