// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

#include "odas/base/contract.hpp"

namespace odas {

/// Text of a hop, written without allocation: the room is taken once, row by row it is made sure of, and it
/// grows if a row should ever need more. Numbers as C's printf has them, but 20 times cheaper.
class TextBuffer {
 public:
  static constexpr std::size_t kUsualSize = 4096;  // bytes: few hops need more

  /// Room for `size` bytes.
  explicit TextBuffer(std::size_t size) : bytes_(size) {}

  void clear() noexcept { used_ = 0; }
  [[nodiscard]] std::span<const char> text() const noexcept { return {bytes_.data(), used_}; }

  /// Makes sure that `size` more bytes fit. What follows up to that size checks nothing.
  void need(std::size_t size) {
    if (bytes_.size() - used_ < size) bytes_.resize(2 * bytes_.size() + size);
  }

  void put(char c) noexcept { *take(1) = c; }
  template <std::size_t N>
  void put(const char (&literal)[N]) noexcept {
    std::memcpy(take(N - 1), literal, N - 1);
  }
  void put(std::string_view text) noexcept { std::memcpy(take(text.size()), text.data(), text.size()); }

  /// `%llu`; at most 20 bytes.
  void put_integer(std::uint64_t value) noexcept;

  /// `%.3f`, digit by digit the same; at most kFixedSize bytes. What is no number is 0.000, for JSON knows
  /// none.
  void put_fixed(float value) noexcept;
  /// `%.6f` of times: not negative, below 2^40.
  void put_seconds(double value) noexcept;

  /// In JSON's quotes, escaped; bytes that are no UTF-8 become U+FFFD. At most kTextSize(size) bytes.
  void put_quoted(std::string_view text) noexcept;

  static constexpr std::size_t kIntegerSize = 20;
  static constexpr std::size_t kFixedSize = 48;
  [[nodiscard]] static constexpr std::size_t quoted_size(std::size_t size) noexcept { return 6 * size + 2; }

 private:
  char* take(std::size_t size) noexcept {
    ODAS_EXPECT(bytes_.size() - used_ >= size);
    char* at = bytes_.data() + used_;
    used_ += size;
    return at;
  }
  void put_padded(std::uint64_t value, int digits) noexcept;

  std::vector<char> bytes_;
  std::size_t used_ = 0;
};

}  // namespace odas
