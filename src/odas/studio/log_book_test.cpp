// SPDX-License-Identifier: MIT
#include "odas/studio/log_book.hpp"

#include "support/studio_parts.hpp"
#include <gtest/gtest.h>

namespace odas::log_book_test {
namespace {

TEST(LogBook, tells_all_pages_each_line_with_its_level) {
  test::HeardMessages heard;
  LogBook log("", heard);
  log.info("one");
  log.error("two");
  ASSERT_EQ(heard.messages().size(), 2U);
  EXPECT_EQ(heard.topics()[0], "log");
  EXPECT_EQ(heard.messages()[0].at("lines").at(0).at("text"), "one");
  EXPECT_EQ(heard.messages()[1].at("lines").at(0).at("level"), "error");
}

}  // namespace
}  // namespace odas::log_book_test
