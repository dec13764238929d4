// SPDX-License-Identifier: MIT
#include "odas/engine/offline.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::offline_test {
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

/// A talker who begins after what was lost, and the first stamp at which anything is heard again.
struct AfterGaps {
  static constexpr std::size_t kFrames = 60000, kFirst = 20000, kReturn = 50000;
  std::vector<test::GappySource::Gap> gaps{
      {kFirst, 1}, {kFirst + 700, 300}, {kFirst + 1400, 128}, {kFirst + 3000, 20000}, {kFirst + 23077, 1013}};

  [[nodiscard]] static Grid<float> samples() {
    Grid<float> all = test::noise(3, kFrames);
    for (std::size_t c = 0; c < 3; ++c) std::fill_n(all[c].data() + 10000, kReturn - 10000, 0.0F);
    return all;
  }
  [[nodiscard]] static HopIndex heard_again(const test::KeepingSink& sink, HopIndex after) {
    for (const auto& hop : sink.hops) {
      if (hop.time > after && !hop.potentials.empty() && hop.potentials[0].energy > 0.01F) return hop.time;
    }
    return 0;
  }
};

TEST(RunOffline, keeps_the_stamps_right_over_what_the_source_has_lost) {
  for (const int rate : {16000, 44100}) {
    AfterGaps gone;
    test::GappySource whole(AfterGaps::samples(), {}, rate);
    test::GappySource gappy(AfterGaps::samples(), gone.gaps, rate);
    std::array<test::KeepingSink, 2> sinks;
    std::array<RunSummary, 2> summaries;
    for (std::size_t i = 0; i < 2; ++i) {
      const Configuration config = test::small_configuration();
      Pipeline pipeline(config.pipeline);
      const std::array<Sink*, 1> sink{&sinks[i]};
      test::GappySource& source = i == 0 ? whole : gappy;
      summaries[i] = run_offline(source, config, pipeline, sink, {});
    }
    const auto silent = static_cast<HopIndex>(30000.0 * 16000 / rate / 128);
    EXPECT_GT(AfterGaps::heard_again(sinks[0], silent), 0U);
    EXPECT_EQ(AfterGaps::heard_again(sinks[0], silent), AfterGaps::heard_again(sinks[1], silent)) << rate;
    EXPECT_EQ(summaries[1].metrics.hops + summaries[1].metrics.skipped_hops, summaries[0].metrics.hops);
    EXPECT_EQ(summaries[1].metrics.lost_frames, 1U + 300 + 128 + 20000 + 1013);
    EXPECT_GT(summaries[1].metrics.skipped_hops, 30U);
    EXPECT_EQ(summaries[1].warnings.size(), 1U) << "the loss";
  }
}

}  // namespace
}  // namespace odas::offline_test
