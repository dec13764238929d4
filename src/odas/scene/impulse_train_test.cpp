// SPDX-License-Identifier: MIT
#include "odas/scene/impulse_train.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "odas/scene/delay_filter.hpp"
#include "odas/scene/random.hpp"

namespace odas::impulse_train_test {
namespace {

TEST(ImpulseTrain, Is_what_the_delay_filter_gives_within_40_dB_in_the_whole_band) {
  constexpr std::size_t kSamples = 300;
  const DelayFilter oracle;
  ImpulseTrain train(kSamples);
  Random random(3);
  std::vector<float> expected(kSamples), found(kSamples);
  for (int i = 0; i < 50; ++i) {
    const float delay = 150 + 80 * random.uniform();
    const float gain = random.uniform();
    oracle.add(delay, gain, expected);
    train.add(delay, gain);
  }
  train.render(found);
  double error = 0, power = 0;
  for (std::size_t n = 0; n < kSamples; ++n) {
    error += std::pow(static_cast<double>(found[n] - expected[n]), 2);
    power += std::pow(static_cast<double>(expected[n]), 2);
  }
  EXPECT_LT(10 * std::log10(error / power), -40);
}

TEST(ImpulseTrain, Delays_every_frequency_by_the_same) {
  constexpr std::size_t kSamples = 128;
  for (const float delay : {40.F, 40.13F, 40.5F, 41.99F}) {
    ImpulseTrain train(kSamples);
    train.add(delay, 1);
    std::vector<float> h(kSamples);
    train.render(h);
    for (const double omega : {0.1, 1.0, 1.5}) {
      std::complex<double> sum = 0;
      for (std::size_t n = 0; n < h.size(); ++n) {
        sum += static_cast<double>(h[n]) *
               std::polar(1.0, omega * (static_cast<double>(delay) - static_cast<double>(n)));
      }
      EXPECT_NEAR(std::abs(sum - 1.0), 0, 2e-3) << delay << " samples, " << omega;
    }
  }
}

TEST(ImpulseTrain, Adds_to_what_is_there_and_forgets_when_cleared) {
  ImpulseTrain train(64);
  train.add(20, 1);
  train.add(1e6F, 1);  // behind the end
  std::vector<float> h(64, 0.25F);
  train.render(h);
  EXPECT_NEAR(h[20], 1.25F, 1e-5F);
  EXPECT_NEAR(h[21], 0.25F, 1e-5F);
  train.clear();
  std::vector<float> silent(64);
  train.render(silent);
  EXPECT_EQ(silent, std::vector<float>(64));
}

}  // namespace
}  // namespace odas::impulse_train_test
