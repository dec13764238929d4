// SPDX-License-Identifier: MIT
#include "odas/separation/beam_report.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace odas::beam_report_test {
namespace {

TEST(BeamReport, says_that_a_mean_of_four_microphones_gains_6_dB) {
  Grid<cfloat> weights(4, 9);
  for (std::size_t m = 0; m < 4; ++m) {
    for (std::size_t k = 1; k < 9; ++k) weights[m][k] = std::polar(0.25F, static_cast<float>(m * k));
  }
  EXPECT_NEAR(white_noise_gain_db(weights), 6.02F, 0.01F) << "the first bin is not used, and does not count";
}

TEST(BeamReport, knows_nothing_of_a_beam_that_hears_nothing) {
  const Grid<cfloat> weights(4, 9);
  EXPECT_TRUE(std::isnan(white_noise_gain_db(weights)));
}

}  // namespace
}  // namespace odas::beam_report_test
