// SPDX-License-Identifier: MIT
#include "odas/studio/rare_notes.hpp"

#include <gtest/gtest.h>

namespace odas::rare_notes_test {
namespace {

TEST(RareNotes, let_each_kind_through_once_a_minute) {
  RareNotes notes;
  const RareNotes::Clock::time_point now{};
  EXPECT_TRUE(notes.is_due("a", now));
  EXPECT_FALSE(notes.is_due("a", now + std::chrono::seconds(59)));
  EXPECT_TRUE(notes.is_due("b", now));
  EXPECT_TRUE(notes.is_due("a", now + std::chrono::seconds(60)));
  EXPECT_FALSE(notes.is_due("a", now + std::chrono::seconds(61)));
}

}  // namespace
}  // namespace odas::rare_notes_test
