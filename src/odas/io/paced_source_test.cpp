// SPDX-License-Identifier: MIT
#include "odas/io/paced_source.hpp"

#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::paced_source_test {
namespace {

using Clock = PacedSource::Clock;

/// Time that passes when somebody sleeps, or when the test says so.
struct FakeTime {
  Clock::time_point now{};
  [[nodiscard]] PacedSource::Time time() {
    return {[this] { return now; }, [this](Clock::duration d) { now += d; }};
  }
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(now.time_since_epoch()).count();
  }
};

PacedSource source_of(std::size_t frames, FakeTime& time, int rate = 16000) {
  return {std::make_unique<test::MemorySource>(test::noise(1, frames), rate), time.time()};
}

TEST(PacedSource, gives_each_block_when_it_would_have_been_heard) {
  FakeTime time;
  PacedSource source = source_of(1000, time);
  Grid<float> block(1, 160);
  for (int i = 1; i <= 6; ++i) {
    EXPECT_EQ(source.read(block).frames, 160U);
    EXPECT_NEAR(time.seconds(), 0.01 * i, 1e-8);
  }
  const ReadResult last = source.read(block);
  EXPECT_EQ(last.frames, 40U);
  EXPECT_TRUE(last.end);
}

TEST(PacedSource, does_not_drift_however_long_it_plays) {
  FakeTime time;
  PacedSource source = source_of(882000, time, 44100);
  Grid<float> block(1, 127);
  std::size_t frames = 0;
  while (frames < 837900) frames += source.read(block).frames;
  EXPECT_NEAR(time.seconds(), static_cast<double>(frames) / 44100, 1e-6);
}

TEST(PacedSource, catches_up_after_it_had_to_wait_and_loses_nothing) {
  FakeTime time;
  PacedSource source = source_of(16000, time);
  Grid<float> block(1, 160);
  EXPECT_EQ(source.read(block).frames, 160U);
  time.now += std::chrono::milliseconds(500);
  const double late = time.seconds();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(source.read(block).frames, 160U);
  EXPECT_EQ(time.seconds(), late) << "these were due";
  EXPECT_EQ(source.read(block).lost, 0U);
}

TEST(PacedSource, returns_from_a_long_block_so_that_the_program_can_stop) {
  FakeTime time;
  PacedSource source = source_of(16000, time);
  Grid<float> block(1, 8000);
  int reads = 0;
  while (source.read(block).frames == 0) ++reads;
  EXPECT_EQ(reads, 4);
  EXPECT_NEAR(time.seconds(), 0.5, 1e-8);
  EXPECT_FALSE(source.live()) << "it is still a recording";
}

}  // namespace
}  // namespace odas::paced_source_test
