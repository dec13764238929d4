// SPDX-License-Identifier: MIT
#include "odas/config/phrases.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace odas::phrases_test {
namespace {

TEST(Phrases, write_numbers_as_a_user_would) {
  EXPECT_EQ(number_text(16000.0), "16000");
  EXPECT_EQ(number_text(0.1F), "0.1");
  EXPECT_EQ(number_text(1e-20F), "1e-20");
  EXPECT_EQ(number_text(-2.5), "-2.5");
  EXPECT_EQ(number_text(1000000000.0), "1000000000");
  EXPECT_EQ(number_text(1e300), "1e+300");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Phrases, say_a_range_in_words) {
  EXPECT_EQ(range_text({0, 1}), "0 to 1");
  EXPECT_EQ(range_text(kPositive), "more than 0");
  EXPECT_EQ(range_text({0, 1, true}), "more than 0, at most 1");
  EXPECT_EQ(range_text(kNotNegative), "at least 0");
  EXPECT_EQ(range_text({-INFINITY, 3}), "at most 3");
  EXPECT_EQ(range_text(kAny), "");
}

TEST(Phrases, list_choices_with_an_or_before_the_last) {
  constexpr std::array<std::string_view, 3> kThree{"a", "b", "c"};
  EXPECT_EQ(choices_text(kThree), "\"a\", \"b\" or \"c\"");
  EXPECT_EQ(choices_text(std::span(kThree).first(1)), "\"a\"");
  EXPECT_EQ(in_quotes("x"), "\"x\"");
}

}  // namespace
}  // namespace odas::phrases_test
