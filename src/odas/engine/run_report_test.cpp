// SPDX-License-Identifier: MIT
#include "odas/engine/run_report.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::run_report_test {
namespace {

TEST(HealthWatch, tells_what_is_wrong_while_the_run_goes_on) {
  Grid<float> samples = test::noise(2, 16000);
  std::fill(samples[1].begin(), samples[1].end(), 0.0F);
  test::MemorySource source(samples);
  RunSummary summary;
  const RunOptions options;
  BlockFeed feed(source, options, summary);
  InputHealth health({1, 2}, 16000);
  HealthWatch watch(health, 16000, feed);
  health.watch(samples);
  watch.passed(1000);
  EXPECT_TRUE(summary.warnings.empty()) << "not for each block";
  watch.passed(15000);
  EXPECT_EQ(summary.warnings, std::vector<std::string>{"microphone 2 (channel 2) is silent"});
}

TEST(FinishSummary, keeps_what_was_lost_and_warns_of_it) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  HopLoop loop(config, 3, 16000, pipeline);
  test::MemorySource source(test::noise(3, 1));
  RunSummary summary;
  summary.metrics.dropped_hops = 3;
  summary.metrics.overruns = 4;
  const RunOptions options;
  BlockFeed feed(source, options, summary);
  const SinkGroup group({});
  Grid<float> block(3, 128);
  block[0][0] = std::numeric_limits<float>::infinity();
  loop.push(block, [](const HopResult&) {});
  finish_summary(summary, loop, group, feed);
  EXPECT_EQ(summary.metrics.hops, 1U);
  EXPECT_EQ(summary.metrics.dropped_hops, 3U);
  EXPECT_EQ(summary.metrics.overruns, 4U);
  ASSERT_EQ(summary.warnings.size(), 3U);
  EXPECT_TRUE(summary.warnings[0].starts_with("1 samples of the input were not numbers"));
}

}  // namespace
}  // namespace odas::run_report_test
