// SPDX-License-Identifier: MIT
#include "odas/engine/offline.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

struct SmallRun {
  Configuration config = test::small_configuration();
  test::MemorySource source{test::noise(3, 1000)};
  test::KeepingSink sink;
  RunOptions options;

  RunSummary operator()() {
    Pipeline pipeline(config.pipeline);
    const std::array<Sink*, 1> sinks{&sink};
    return run_offline(source, config, pipeline, sinks, options);
  }
};

TEST(RunOffline, writes_every_hop_and_closes_the_sinks) {
  SmallRun run;
  const RunSummary summary = run();
  EXPECT_EQ(summary.exit_code(), 0);
  EXPECT_EQ(summary.frames, 1000U);
  EXPECT_EQ(summary.metrics.hops, 8U) << "the last one padded";
  ASSERT_EQ(run.sink.hops.size(), 8U);
  EXPECT_EQ(run.sink.hops.front().time, 1U);
  EXPECT_EQ(run.sink.closes, 1);
}

TEST(RunOffline, has_one_hop_more_than_full_blocks_when_it_runs_as_odas) {
  SmallRun run;
  run.options.silent_first_block = true;
  run.options.pad_last_block = false;
  EXPECT_EQ(run().metrics.hops, 1U + 1000 / 128);
  for (const Potential& p : run.sink.hops[0].potentials) EXPECT_EQ(p.energy, 0);
}

TEST(RunOffline, ends_well_when_asked_to_stop) {
  SmallRun run;
  std::atomic<bool> stop{false};
  run.options.stop = &stop;
  run.options.progress = [&](std::uint64_t done, std::optional<std::uint64_t>) { stop = done >= 512; };
  const RunSummary summary = run();
  EXPECT_EQ(summary.end, RunSummary::End::stopped);
  EXPECT_EQ(run.sink.hops.size(), 4U);
  EXPECT_EQ(run.sink.closes, 1);
}

TEST(RunOffline, ends_when_a_sink_fails_and_says_why) {
  SmallRun run;
  run.source = test::MemorySource(test::noise(3, 100000));
  run.sink.fail_at = 3;
  const RunSummary summary = run();
  EXPECT_EQ(summary.exit_code(), 1);
  EXPECT_EQ(summary.fault, "kept: no more room");
  EXPECT_LT(summary.frames, 1000U);
  EXPECT_EQ(run.sink.closes, 1);
}

TEST(RunOffline, refuses_a_source_without_the_channels_of_the_map) {
  SmallRun run;
  run.source = test::MemorySource(test::noise(2, 1000));
  EXPECT_THROW(run(), ConfigError);
}

}  // namespace
}  // namespace odas
