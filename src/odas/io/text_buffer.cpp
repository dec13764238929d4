// SPDX-License-Identifier: MIT
#include "odas/io/text_buffer.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace odas {
namespace {

/// Length of the UTF-8 character at the front of `text`; 0 where it is none.
std::size_t utf8_length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t size = lead < 0x80   ? 1
                           : lead < 0xC2 ? 0
                           : lead < 0xE0 ? 2
                           : lead < 0xF0 ? 3
                           : lead < 0xF5 ? 4
                                         : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  }
  // Overlong forms, surrogates, and what lies beyond Unicode
  const bool wrong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F) ||
                     (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F);
  return wrong ? 0 : size;
}

}  // namespace

void TextBuffer::put_integer(std::uint64_t value) noexcept {
  ODAS_EXPECT(bytes_.size() - used_ >= kIntegerSize);
  char* at = bytes_.data() + used_;
  used_ += static_cast<std::size_t>(std::to_chars(at, bytes_.data() + bytes_.size(), value).ptr - at);
}

void TextBuffer::put_padded(std::uint64_t value, int digits) noexcept {
  char* at = take(static_cast<std::size_t>(digits));
  for (int i = digits - 1; i >= 0; --i) {
    at[i] = static_cast<char>('0' + value % 10);
    value /= 10;
  }
}

void TextBuffer::put_fixed(float value) noexcept {
  // 24 bits of a float times 1000 (7 bits, as 8 is only an exponent) are exact in a double, so that rounding
  // half to even gives what printf gives.
  constexpr float kExact = 1e9F;
  if (!(std::fabs(value) < kExact)) {
    if (!std::isfinite(value)) return put("0.000");
    char* at = bytes_.data() + used_;
    const auto [end, error] =
        std::to_chars(at, bytes_.data() + bytes_.size(), value, std::chars_format::fixed, 3);
    if (error == std::errc()) used_ += static_cast<std::size_t>(end - at);
    return;
  }
  if (std::signbit(value)) put('-');
  const auto thousandths =
      static_cast<std::uint64_t>(std::llrint(std::fabs(static_cast<double>(value)) * 1000));
  const std::uint64_t whole = thousandths / 1000;
  const auto rest = static_cast<unsigned>(thousandths % 1000);
  if (whole < 10) {
    put(static_cast<char>('0' + whole));
  } else {
    put_integer(whole);
  }
  char* at = take(4);
  at[0] = '.';
  at[1] = static_cast<char>('0' + rest / 100);
  at[2] = static_cast<char>('0' + rest / 10 % 10);
  at[3] = static_cast<char>('0' + rest % 10);
}

void TextBuffer::put_seconds(double value) noexcept {
  const auto millionths = static_cast<std::uint64_t>(std::llrint(value * 1e6));
  put_integer(millionths / 1'000'000);
  put('.');
  put_padded(millionths % 1'000'000, 6);
}

void TextBuffer::put_quoted(std::string_view text) noexcept {
  put('"');
  while (!text.empty()) {
    const char c = text.front();
    std::size_t length = 1;
    if (c == '"' || c == '\\') {
      put('\\');
      put(c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr std::string_view kHex = "0123456789abcdef";
      put("\\u00");
      put(kHex[static_cast<unsigned char>(c) >> 4U]);
      put(kHex[static_cast<unsigned char>(c) & 15U]);
    } else if (static_cast<unsigned char>(c) < 0x80) {
      put(c);
    } else if (const std::size_t utf8 = utf8_length(text); utf8 > 0) {
      length = utf8;
      put(text.substr(0, length));
    } else {
      put("\\ufffd");
    }
    text.remove_prefix(length);
  }
  put('"');
}

}  // namespace odas
