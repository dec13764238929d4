// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace odas {

/// At most N bytes of text held in place: copied without allocation. Longer text is cut.
template <std::size_t N>
class ShortString {
 public:
  static constexpr std::size_t kCapacity = N;

  constexpr ShortString() = default;
  constexpr ShortString(std::string_view text) noexcept  // NOLINT(google-explicit-constructor)
      : size_(static_cast<std::uint8_t>(std::min(text.size(), N))) {
    std::copy_n(text.data(), size_, bytes_.begin());
  }
  constexpr ShortString(const char* text) noexcept  // NOLINT(google-explicit-constructor)
      : ShortString(std::string_view(text)) {}

  [[nodiscard]] constexpr std::string_view view() const noexcept { return {bytes_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
  friend constexpr bool operator==(const ShortString& a, const ShortString& b) noexcept {
    return a.view() == b.view();
  }

 private:
  static_assert(N < 256);
  std::array<char, N> bytes_{};
  std::uint8_t size_ = 0;
};

}  // namespace odas
