// SPDX-License-Identifier: MIT
#include "odas/config/nearest.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace odas::nearest_test {
namespace {

constexpr std::array<std::string_view, 4> kWords{"hopSize", "frameSize", "nPots", "b"};

TEST(Nearest, counts_insertions_deletions_changes_and_swaps_as_one_each) {
  EXPECT_EQ(edit_distance("hopSize", "hopSize"), 0U);
  EXPECT_EQ(edit_distance("hopSize", "hopSiz"), 1U);
  EXPECT_EQ(edit_distance("hopSize", "hoppSize"), 1U);
  EXPECT_EQ(edit_distance("hopSize", "hapSize"), 1U);
  EXPECT_EQ(edit_distance("hopSize", "hpoSize"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
}

TEST(Nearest, takes_upper_and_lower_case_alike) { EXPECT_EQ(edit_distance("HOPSIZE", "hopSize"), 0U); }

TEST(Nearest, finds_the_word_that_was_meant) {
  EXPECT_EQ(nearest("hopsize", kWords), "hopSize");
  EXPECT_EQ(nearest("frmaeSize", kWords), "frameSize");
  EXPECT_EQ(nearest("npot", kWords), "nPots");
}

TEST(Nearest, is_silent_where_nothing_is_near) {
  EXPECT_EQ(nearest("temperature", kWords), "");
  EXPECT_EQ(nearest("x", kWords), "") << "a word of one letter is not near to another of one letter";
  EXPECT_EQ(nearest(std::string(100000, 'a'), kWords), "");
  EXPECT_EQ(nearest("hopSize", {}), "");
}

}  // namespace
}  // namespace odas::nearest_test
