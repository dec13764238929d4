// SPDX-License-Identifier: MIT
#include "odas/io/text_buffer.hpp"

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

#include "support/allocation_counter.hpp"
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::text_buffer_test {
namespace {

template <class Put>
std::string text_of(Put put) {
  TextBuffer buffer(1024);
  put(buffer);
  const auto text = buffer.text();
  return {text.begin(), text.end()};
}

std::string fixed(float value) {
  return text_of([&](TextBuffer& b) { b.put_fixed(value); });
}
std::string json_of(std::string_view text) {
  return text_of([&](TextBuffer& b) { b.put_quoted(text); });
}
std::string printed(float value) {
  char text[64];
  std::snprintf(text, sizeof text, "%1.3f", static_cast<double>(value));
  return text;
}

TEST(TextBuffer, prints_what_printf_prints_for_each_of_many_directions) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(-1.1F, 1.1F);
  for (int i = 0; i < 200000; ++i) {
    const float x = unit(random);
    ASSERT_EQ(fixed(x), printed(x)) << std::bit_cast<std::uint32_t>(x);
  }
}

RC_GTEST_PROP(TextBuffer, prints_what_printf_prints_for_any_finite_float, (std::uint32_t bits)) {
  const auto x = std::bit_cast<float>(bits);
  if (!std::isfinite(x)) return;
  RC_ASSERT(fixed(x) == printed(x));
}

TEST(TextBuffer, prints_the_hard_cases_as_printf) {
  for (const float x : {0.F,       -0.F,     -0.0001F,    -0.0005F, 0.0005F, 0.0625F,  0.1875F,
                        0.9995F,   0.99951F, -0.9999F,    1.F,      9.9995F, 9.9996F,  10.F,
                        999999.9F, 1e9F,     123456789.F, 1e15F,    3.4e38F, -3.4e38F, 1e-45F}) {
    EXPECT_EQ(fixed(x), printed(x));
  }
  EXPECT_EQ(fixed(-0.0001F), "-0.000") << "as ODAS";
}

TEST(TextBuffer, prints_zero_for_what_is_no_number_in_json) {
  for (const float x : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                        -std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(fixed(x), "0.000");
  }
}

TEST(TextBuffer, prints_integers_and_seconds) {
  const auto integer = [](std::uint64_t value) {
    return text_of([&](TextBuffer& b) { b.put_integer(value); });
  };
  EXPECT_EQ(integer(0), "0");
  EXPECT_EQ(integer(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  const auto seconds = [](double value) { return text_of([&](TextBuffer& b) { b.put_seconds(value); }); };
  EXPECT_EQ(seconds(0), "0.000000");
  EXPECT_EQ(seconds(0.008), "0.008000");
  EXPECT_EQ(seconds(86400.000002), "86400.000002");
}

TEST(TextBuffer, escapes_what_would_break_json) {
  EXPECT_EQ(json_of("dynamic"), "\"dynamic\"");
  EXPECT_EQ(json_of("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(json_of("a\nb\x01"), "\"a\\u000ab\\u0001\"");
  EXPECT_EQ(json_of("René \xF0\x9F\x98\x80"), "\"René \xF0\x9F\x98\x80\"");
  EXPECT_EQ(json_of("cut \xC3"), "\"cut \\ufffd\"");
  EXPECT_EQ(json_of("\xFF\xC0\xAF"), "\"\\ufffd\\ufffd\\ufffd\"") << "no overlong forms either";
  EXPECT_EQ(json_of("\xED\xA0\x80"), "\"\\ufffd\\ufffd\\ufffd\"") << "nor surrogates";
}

RC_GTEST_PROP(TextBuffer, never_needs_more_than_it_says, (const std::string& text)) {
  RC_ASSERT(json_of(text.substr(0, 100)).size() <=
            TextBuffer::quoted_size(std::min<std::size_t>(text.size(), 100)));
}

TEST(TextBuffer, grows_where_a_row_is_longer_than_the_room_and_never_overflows) {
  TextBuffer buffer(4);
  for (int i = 0; i < 100; ++i) {
    buffer.need(10);
    buffer.put("0123456789");
  }
  EXPECT_EQ(buffer.text().size(), 1000U);
  EXPECT_EQ(std::string_view(buffer.text().data() + 990, 10), "0123456789");
}

TEST(TextBuffer, allocates_nothing_within_its_room) {
  TextBuffer buffer(1024);
  const auto before = test::allocations();
  buffer.need(500);
  buffer.put_fixed(0.5F);
  buffer.put_fixed(3e38F);
  buffer.put_integer(12345);
  buffer.put_quoted("tag");
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace odas::text_buffer_test
