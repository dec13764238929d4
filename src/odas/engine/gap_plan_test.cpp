// SPDX-License-Identifier: MIT
#include "odas/engine/gap_plan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::gap_plan_test {
namespace {

TEST(GapPlan, bridges_a_short_gap_with_silence_alone) {
  GapPlan plan(16000, 16000, 128, 4);
  const auto step = plan.bridge(500);
  EXPECT_EQ(step.silence, 500U);
  EXPECT_EQ(step.hops, 0U);
}

TEST(GapPlan, steps_over_whole_hops_once_the_pipeline_has_run_out) {
  GapPlan plan(16000, 16000, 128, 4);
  const auto step = plan.bridge(128 * 100 + 5);
  EXPECT_EQ(step.hops, 96U);
  EXPECT_EQ(step.silence, 4 * 128U + 5U);
}

TEST(GapPlan, costs_nothing_more_for_a_gap_of_a_year) {
  GapPlan plan(48000, 16000, 128, 4);
  const auto step = plan.bridge(std::uint64_t{48000} * 86400 * 365);
  EXPECT_LT(step.silence, 5 * 3 * 128U);
}

RC_GTEST_PROP(GapPlan, never_drifts_however_many_gaps_there_are, ()) {
  const auto rate = *rc::gen::elementOf(std::vector<std::uint64_t>{8000, 16000, 44100, 48000, 96000});
  const auto out = *rc::gen::elementOf(std::vector<std::uint64_t>{8000, 16000, 44100});
  const auto hop = *rc::gen::elementOf(std::vector<std::uint64_t>{100, 128, 441});
  GapPlan plan(static_cast<int>(rate), static_cast<int>(out), hop, 4);
  std::uint64_t lost = 0, silence = 0, hops = 0;
  for (const auto gap :
       *rc::gen::container<std::vector<std::uint64_t>>(rc::gen::inRange<std::uint64_t>(0, 100000))) {
    lost += gap;
    const auto step = plan.bridge(gap);
    silence += step.silence;
    hops += step.hops;
    const std::uint64_t owed = lost * out - silence * out - hops * hop * rate;
    RC_ASSERT(owed < out);  // less than a frame of the source
  }
}

}  // namespace
}  // namespace odas::gap_plan_test
