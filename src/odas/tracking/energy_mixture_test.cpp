// SPDX-License-Identifier: MIT
#include "odas/tracking/energy_mixture.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace odas::energy_mixture_test {
namespace {

TEST(EnergyMixture, is_the_log_of_the_weighted_sum_of_its_gaussians) {
  const EnergyMixture mixture({{0.25F, 0.1F, 0.01F}, {0.75F, 0.5F, 0.04F}});
  const auto gaussian = [](double x, double mean, double variance) {
    return std::exp(-(x - mean) * (x - mean) / (2 * variance)) / std::sqrt(2 * std::numbers::pi * variance);
  };
  for (const double e : {-0.2, 0.1, 0.3, 0.9}) {
    EXPECT_NEAR(mixture.log_density(e),
                std::log(0.25 * gaussian(e, 0.1, 0.01) + 0.75 * gaussian(e, 0.5, 0.04)), 1e-5);
  }
}

TEST(EnergyMixture, of_nothing_is_impossible) {
  EXPECT_EQ(EnergyMixture({}).log_density(0.3), -std::numeric_limits<double>::infinity());
}

TEST(EnergyMixture, adds_logs_that_exp_cannot_hold) {
  EXPECT_NEAR(log_add(2000, 2000), 2000 + std::log(2), 1e-9);
  EXPECT_EQ(log_add(-2000, 1), 1);
}

}  // namespace
}  // namespace odas::energy_mixture_test
