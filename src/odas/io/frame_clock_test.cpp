// SPDX-License-Identifier: MIT
#include "odas/io/frame_clock.hpp"

#include <gtest/gtest.h>

namespace odas::frame_clock_test {
namespace {

using std::chrono::milliseconds;

TEST(FrameClock, gives_each_frame_once) {
  FrameClock clock(16000);
  const FrameClock::Clock::time_point begin{};
  EXPECT_EQ(clock.take(begin), 0U) << "it has not been started";
  clock.start(begin);
  std::uint64_t frames = 0;
  for (int ms = 1; ms <= 3333; ms += 7) frames += clock.take(begin + milliseconds(ms));
  frames += clock.take(begin + milliseconds(4000));
  EXPECT_EQ(frames, 64000U);
  EXPECT_EQ(clock.take(begin + milliseconds(3000)), 0U) << "never back";
  clock.stop();
  EXPECT_EQ(clock.take(begin + milliseconds(9000)), 0U);
}

}  // namespace
}  // namespace odas::frame_clock_test
