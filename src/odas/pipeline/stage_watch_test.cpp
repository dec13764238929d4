// SPDX-License-Identifier: MIT
#include "odas/pipeline/stage_watch.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace odas::stage_watch_test {
namespace {

/// Goes on by 10, 20, 30 ... ns.
std::uint64_t faster_and_faster() noexcept {
  static std::uint64_t now = 0;
  static std::uint64_t step = 0;
  step += 10;
  return now += step;
}

TEST(StageWatch, books_what_passed_to_the_stage_that_it_was_spent_on) {
  StageWatch watch;
  watch.use(&faster_and_faster);
  watch.begin();                     // at 10
  watch.spent_on(Stage::transform);  // at 30
  watch.spent_on(Stage::tracking);   // at 60
  watch.begin();                     // at 100
  watch.spent_on(Stage::transform);  // at 150
  StageTimes expected{};
  expected[static_cast<std::size_t>(Stage::transform)] = 20 + 50;
  expected[static_cast<std::size_t>(Stage::tracking)] = 30;
  EXPECT_EQ(watch.times(), expected);
}

TEST(StageWatch, stands_still_without_a_clock) {
  StageWatch watch;
  watch.begin();
  watch.spent_on(Stage::noise);
  EXPECT_EQ(watch.times(), StageTimes{});
}

}  // namespace
}  // namespace odas::stage_watch_test
