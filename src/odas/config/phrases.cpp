// SPDX-License-Identifier: MIT
#include "odas/config/phrases.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace odas {

namespace {

template <class T>
std::string shortest(T value) {
  std::array<char, 64> buffer{};
  const bool whole = value == std::trunc(value) && std::abs(value) < T{1e10};
  const auto result =
      whole ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), static_cast<long>(value))
            : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

}  // namespace

std::string number_text(double value) { return shortest(value); }
std::string number_text(float value) { return shortest(value); }

std::string in_quotes(std::string_view word) { return '"' + std::string(word) + '"'; }

std::string range_text(const Range& range) {
  const bool from = std::isfinite(range.min);
  const bool to = std::isfinite(range.max);
  if (range.min_excluded && from) {
    return "more than " + number_text(range.min) + (to ? ", at most " + number_text(range.max) : "");
  }
  if (from && to) return number_text(range.min) + " to " + number_text(range.max);
  if (from) return "at least " + number_text(range.min);
  if (to) return "at most " + number_text(range.max);
  return "";
}

std::string choices_text(std::span<const std::string_view> choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
    text += in_quotes(choices[i]);
  }
  return text;
}

}  // namespace odas
