// SPDX-License-Identifier: MIT
#include "odas/tracking/energy_histogram.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace odas::energy_histogram_test {
namespace {

TEST(EnergyHistogram, counts_and_finds_quantiles) {
  EnergyHistogram histogram;
  EXPECT_EQ(histogram.quantile(0.5), 0);
  for (int i = 0; i < 100; ++i) histogram.add(0.0105 + 0.001 * i);
  EXPECT_EQ(histogram.total(), 100);
  EXPECT_NEAR(histogram.quantile(0.5), 0.06, 0.0015);
  EXPECT_NEAR(histogram.quantile(1), 0.1095, 0.0015);
}

TEST(EnergyHistogram, keeps_what_is_outside_at_the_border_and_leaves_out_what_is_no_number) {
  EnergyHistogram histogram;
  histogram.add(-7);
  histogram.add(9);
  histogram.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(histogram.total(), 2);
  EXPECT_EQ(histogram.count(0), 1);
  EXPECT_EQ(histogram.count(EnergyHistogram::kBins - 1), 1);
}

TEST(EnergyHistogram, adds_another) {
  EnergyHistogram a, b;
  a.add(0.1);
  b.add(0.1, 3);
  a.add(b);
  EXPECT_EQ(a.total(), 4);
}

}  // namespace
}  // namespace odas::energy_histogram_test
