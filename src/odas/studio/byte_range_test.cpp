// SPDX-License-Identifier: MIT
#include "odas/studio/byte_range.hpp"

#include <gtest/gtest.h>

namespace odas::byte_range_test {
namespace {

TEST(ByteRange, reads_what_browsers_ask_for) {
  ByteRange range;
  EXPECT_EQ(read_range("bytes=0-", 10, range), RangeKind::part);
  EXPECT_EQ(range.size(), 10U);
  EXPECT_EQ(read_range("bytes=3-100", 10, range), RangeKind::part);
  EXPECT_EQ(range.first, 3U);
  EXPECT_EQ(range.last, 9U);
  EXPECT_EQ(read_range("bytes=-4", 10, range), RangeKind::part);
  EXPECT_EQ(range.first, 6U);
  EXPECT_EQ(read_range("bytes=-40", 10, range), RangeKind::part);
  EXPECT_EQ(range.first, 0U);
}

TEST(ByteRange, refuses_what_is_beyond_the_end) {
  ByteRange range;
  EXPECT_EQ(read_range("bytes=10-", 10, range), RangeKind::unsatisfiable);
  EXPECT_EQ(read_range("bytes=0-", 0, range), RangeKind::unsatisfiable);
  EXPECT_EQ(read_range("bytes=-0", 10, range), RangeKind::unsatisfiable);
}

TEST(ByteRange, takes_everything_else_for_the_whole) {
  ByteRange range;
  for (const char* header : {"", "bytes=", "bytes=-", "bytes=a-b", "bytes=5-2", "lines=1-2", "bytes=0-1,4-5",
                             "bytes=99999999999999999999-"}) {
    EXPECT_EQ(read_range(header, 10, range), RangeKind::whole) << header;
  }
}

}  // namespace
}  // namespace odas::byte_range_test
