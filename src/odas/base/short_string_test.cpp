// SPDX-License-Identifier: MIT
#include "odas/base/short_string.hpp"

#include <string>

#include <gtest/gtest.h>

namespace odas::short_string_test {
namespace {

TEST(ShortString, Holds_what_fits_and_cuts_the_rest) {
  EXPECT_EQ(ShortString<8>("dynamic").view(), "dynamic");
  EXPECT_TRUE(ShortString<8>("").empty());
  const std::string tag(300, 'x');  // ODAS fault B4: long tags ran over their buffers
  EXPECT_EQ(ShortString<63>(tag).view(), std::string(63, 'x'));
}

TEST(ShortString, Equals_by_content) {
  EXPECT_EQ(ShortString<8>("a"), ShortString<8>("a"));
  EXPECT_FALSE(ShortString<8>("a") == ShortString<8>("ab"));
}

}  // namespace
}  // namespace odas::short_string_test
