// SPDX-License-Identifier: MIT
#include "odas/pipeline/input_guard.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace odas::input_guard_test {
namespace {

TEST(InputGuard, Passes_a_sane_hop_as_it_is) {
  InputGuard guard(2, 4);
  Grid<float> hop(2, 4);
  hop.fill(-1.5F);
  EXPECT_EQ(guard.pass(hop).data(), hop.data());
  EXPECT_EQ(guard.refused(), 0U);
}

TEST(InputGuard, Takes_what_no_microphone_can_mean_for_silence_and_counts_it) {
  InputGuard guard(2, 4);
  Grid<float> hop(2, 4);
  hop.fill(0.5F);
  hop[0][1] = std::numeric_limits<float>::quiet_NaN();
  hop[1][0] = -std::numeric_limits<float>::infinity();
  hop[1][3] = 1e20F;
  const auto passed = guard.pass(hop);
  EXPECT_EQ(passed[0][1], 0);
  EXPECT_EQ(passed[1][0], 0);
  EXPECT_EQ(passed[1][3], 0);
  EXPECT_EQ(passed[0][0], 0.5F);
  EXPECT_EQ(guard.refused(), 3U);
  guard.reset();
  EXPECT_EQ(guard.refused(), 0U);
}

}  // namespace
}  // namespace odas::input_guard_test
