// SPDX-License-Identifier: MIT
#include "odas/engine/live.hpp"

#include <array>
#include <chrono>
#include <cstring>
#include <thread>

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

#include "odas/engine/offline.hpp"

namespace odas::live_test {
namespace {

/// Two talkers would do no better: the noise of two channels is common, so that potentials and tracks come.
Grid<float> sound(std::size_t frames) {
  Grid<float> samples = test::noise(3, frames);
  const Grid<float> common = test::noise(1, frames, 9);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 2; i < frames; ++i) samples[c][i] = 0.3F * samples[c][i] + common[0][i - c];
  }
  return samples;
}

template <class Runner>
RunSummary run_with(Runner runner, AudioSource& source, Sink& sink, const RunOptions& options = {}) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  const std::array<Sink*, 1> sinks{&sink};
  return runner(source, config, pipeline, sinks, options);
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(RunLive, is_bit_equal_to_the_run_without_threads) {
  for (const int rate : {16000, 44100}) {
    const Grid<float> samples = sound(40000);
    test::MemorySource a(samples, rate);
    test::MemorySource b(samples, rate);
    test::KeepingSink threaded;
    test::KeepingSink sequential;
    const RunSummary x = run_with(run_live, a, threaded);
    const RunSummary y = run_with(run_offline, b, sequential);
    EXPECT_EQ(x.metrics.hops, y.metrics.hops);
    EXPECT_EQ(x.frames, y.frames);
    ASSERT_EQ(threaded.hops.size(), sequential.hops.size());
    bool tracked = false;
    for (std::size_t i = 0; i < threaded.hops.size(); ++i) {
      const auto& p = threaded.hops[i];
      const auto& q = sequential.hops[i];
      ASSERT_EQ(p.time, q.time);
      ASSERT_TRUE(same_bits(p.separated, q.separated)) << i;
      for (std::size_t k = 0; k < p.potentials.size(); ++k) {
        ASSERT_EQ(p.potentials[k].direction, q.potentials[k].direction);
        ASSERT_EQ(p.potentials[k].energy, q.potentials[k].energy);
      }
      for (std::size_t k = 0; k < p.tracks.size(); ++k) {
        ASSERT_EQ(p.tracks[k].id, q.tracks[k].id);
        ASSERT_EQ(p.tracks[k].direction, q.tracks[k].direction);
        tracked = tracked || p.tracks[k].id != 0;
      }
    }
    EXPECT_TRUE(tracked) << "or the comparison would be of silence";
  }
}

TEST(RunLive, loses_nothing_of_a_recording_however_slow_its_sinks) {
  struct Slow : test::KeepingSink {
    IoStatus write(const HopResult& hop) override {
      if (hop.time % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      return KeepingSink::write(hop);
    }
  } sink;
  test::MemorySource source(test::noise(3, 128 * 300));
  const RunSummary summary = run_with(run_live, source, sink);
  EXPECT_EQ(sink.hops.size(), 300U);
  EXPECT_EQ(summary.metrics.dropped_hops, 0U);
}

TEST(RunLive, drops_and_counts_hops_of_a_live_source_that_a_sink_is_too_slow_for) {
  std::atomic<bool> input_over{false};
  struct Stuck : test::KeepingSink {
    explicit Stuck(std::atomic<bool>& over) : over_(over) {}
    IoStatus write(const HopResult& hop) override {
      while (!over_) std::this_thread::yield();
      return KeepingSink::write(hop);
    }
    std::atomic<bool>& over_;
  } sink(input_over);
  /// Gives a block only once the engine has taken the ones before, as a sound card would.
  struct Paced : test::MemorySource {
    Paced(Grid<float> samples, std::atomic<bool>& over) : MemorySource(std::move(samples)), over_(over) {}
    ReadResult read(GridView<float> block) override {
      std::this_thread::sleep_for(std::chrono::microseconds(300));
      ReadResult result = MemorySource::read(block);
      if (result.end) over_ = true;
      return result;
    }
    std::atomic<bool>& over_;
  } source(test::noise(3, 128 * 400), input_over);
  source.live_source = true;
  const RunSummary summary = run_with(run_live, source, sink);
  EXPECT_GT(summary.metrics.dropped_hops, 0U);
  EXPECT_EQ(sink.hops.size() + summary.metrics.dropped_hops, summary.metrics.hops);
  EXPECT_EQ(summary.metrics.hops + summary.metrics.skipped_hops, 400U) << "time does not slip";
  EXPECT_EQ(summary.metrics.lost_frames, 128 * summary.metrics.overruns);
  for (std::size_t i = 1; i < sink.hops.size(); ++i) EXPECT_GT(sink.hops[i].time, sink.hops[i - 1].time);
}

TEST(RunLive, ends_when_a_sink_fails) {
  test::KeepingSink sink;
  sink.fail_at = 3;
  test::MemorySource source(test::noise(3, 128 * 20000));
  const RunSummary summary = run_with(run_live, source, sink);
  EXPECT_EQ(summary.end, RunSummary::End::sink_failed);
  EXPECT_EQ(summary.fault, "kept: no more room");
  EXPECT_LT(summary.frames, 128U * 20000) << "it does not read on to the end";
  EXPECT_EQ(sink.closes, 1);
}

TEST(RunLive, ends_well_when_asked_to_stop_and_writes_what_it_has_read) {
  std::atomic<bool> stop{false};
  RunOptions options;
  options.stop = &stop;
  options.progress = [&](std::uint64_t done, std::optional<std::uint64_t>) { stop = done >= 128 * 10; };
  test::KeepingSink sink;
  test::MemorySource source(test::noise(3, 128 * 1000));
  const RunSummary summary = run_with(run_live, source, sink, options);
  EXPECT_EQ(summary.exit_code(), 0);
  EXPECT_EQ(sink.hops.size(), 10U);
}

TEST(RunLive, runs_without_any_sink) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  test::MemorySource source(test::noise(3, 1280));
  EXPECT_EQ(run_live(source, config, pipeline, {}, {}).metrics.hops, 10U);
}

TEST(RunLive, tells_of_a_dead_microphone) {
  Grid<float> samples = test::noise(3, 32000);
  std::fill(samples[1].begin(), samples[1].end(), 0.0F);
  test::MemorySource source(samples);
  test::KeepingSink sink;
  EXPECT_EQ(run_with(run_live, source, sink).warnings,
            std::vector<std::string>{"microphone 2 (channel 2) is silent"});
}

TEST(RunLive, steps_over_what_the_source_has_lost_as_the_run_without_threads) {
  const std::vector<test::GappySource::Gap> gaps{{1000, 77}, {5000, 20001}, {30000, 128}};
  test::GappySource a(sound(40000), gaps);
  test::GappySource b(sound(40000), gaps);
  test::KeepingSink threaded;
  test::KeepingSink sequential;
  const RunSummary x = run_with(run_live, a, threaded);
  const RunSummary y = run_with(run_offline, b, sequential);
  EXPECT_EQ(x.metrics.hops + x.metrics.skipped_hops, 313U) << "40000 frames";
  EXPECT_EQ(x.metrics.lost_frames, y.metrics.lost_frames);
  ASSERT_EQ(threaded.hops.size(), sequential.hops.size());
  for (std::size_t i = 0; i < threaded.hops.size(); ++i) {
    ASSERT_EQ(threaded.hops[i].time, sequential.hops[i].time);
    ASSERT_TRUE(same_bits(threaded.hops[i].separated, sequential.hops[i].separated)) << i;
  }
}

}  // namespace
}  // namespace odas::live_test
