// SPDX-License-Identifier: MIT
// Numbers and texts as MCAP and ZIP have them: little-endian, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace odas {

template <class Int>
void put_le(std::vector<char>& to, Int value) {
  static_assert(std::is_unsigned_v<Int>);
  for (std::size_t i = 0; i < sizeof value; ++i) to.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
}
inline void put_bytes(std::vector<char>& to, std::span<const char> bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
}
/// Its length in 32 bits, and the text.
inline void put_le_text(std::vector<char>& to, std::string_view text) {
  put_le(to, static_cast<std::uint32_t>(text.size()));
  put_bytes(to, text);
}

/// Takes numbers and texts off the front. Beyond the end everything is 0 and "", and `ok` is false.
class LittleEndianReader {
 public:
  explicit LittleEndianReader(std::span<const char> bytes) : rest_(bytes) {}

  template <class Int>
  Int take() {
    Int value = 0;
    const std::span<const char> bytes = take_bytes(sizeof(Int));
    for (std::size_t i = bytes.size(); i-- > 0;) {
      value =
          static_cast<Int>((static_cast<std::uint64_t>(value) << 8) | static_cast<std::uint8_t>(bytes[i]));
    }
    return value;
  }
  std::span<const char> take_bytes(std::size_t count) {
    if (count > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const std::span<const char> taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }
  std::string_view take_text() {
    const std::span<const char> bytes = take_bytes(take<std::uint32_t>());
    return {bytes.data(), bytes.size()};
  }
  [[nodiscard]] std::span<const char> rest() const noexcept { return rest_; }
  [[nodiscard]] bool ok() const noexcept { return ok_; }

 private:
  std::span<const char> rest_;
  bool ok_ = true;
};

}  // namespace odas
