// SPDX-License-Identifier: MIT
#include "odas/engine/metrics.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace odas::metrics_test {
namespace {

using std::chrono::nanoseconds;

RC_GTEST_PROP(TimeHistogram, quantiles_are_right_within_a_fifth, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 200);
  auto times = *rc::gen::container<std::vector<long>>(size, rc::gen::inRange<long>(1000, 4'000'000'000L));
  TimeHistogram histogram;
  for (const long t : times) histogram.add(nanoseconds(t));
  std::sort(times.begin(), times.end());
  for (const double q : {0.1, 0.5, 0.99, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(size))) - 1;
    const auto exact = static_cast<double>(times[rank]);
    const auto found = static_cast<double>(histogram.quantile(q).count());
    RC_ASSERT(found >= exact);
    RC_ASSERT(found <= 1.25 * exact + 1);
  }
  RC_ASSERT(histogram.max().count() == times.back());
}

TEST(TimeHistogram, takes_times_of_any_length) {
  TimeHistogram histogram;
  histogram.add(nanoseconds(-5));
  histogram.add(nanoseconds(0));
  histogram.add(std::chrono::hours(100));
  EXPECT_EQ(histogram.quantile(1), histogram.quantile(0.9));
  EXPECT_LE(histogram.quantile(0.5), nanoseconds(1250));
  EXPECT_EQ(histogram.max(), std::chrono::hours(100));
}

TEST(TimeHistogram, that_is_empty_says_zero) { EXPECT_EQ(TimeHistogram().quantile(0.5), nanoseconds(0)); }

TEST(Metrics, real_time_share_is_time_spent_over_time_heard) {
  Metrics metrics;
  EXPECT_EQ(metrics.real_time_share(), 0);
  metrics.sound_seconds = 2;
  metrics.hop_time.add(std::chrono::milliseconds(300));
  metrics.hop_time.add(std::chrono::milliseconds(200));
  EXPECT_DOUBLE_EQ(metrics.real_time_share(), 0.25);
}

}  // namespace
}  // namespace odas::metrics_test
