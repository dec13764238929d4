// SPDX-License-Identifier: MIT
#include "odas/studio/crc32.hpp"

#include <string_view>

#include <gtest/gtest.h>

namespace odas::crc32_test {
namespace {

TEST(Crc32, has_the_values_of_the_standard) {
  EXPECT_EQ(crc32_of({}), 0U);
  EXPECT_EQ(crc32_of(std::string_view("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32_of(std::string_view("The quick brown fox jumps over the lazy dog")), 0x414FA339U);
}

TEST(Crc32, does_not_depend_on_the_pieces) {
  const std::string_view text = "a text that is longer than eight bytes, in two pieces";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    Crc32 sum;
    sum.add(text.substr(0, cut));
    sum.add(text.substr(cut));
    EXPECT_EQ(sum.value(), crc32_of(text)) << cut;
  }
}

}  // namespace
}  // namespace odas::crc32_test
