// SPDX-License-Identifier: MIT
#include "odas/dsp/mcra.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace odas::mcra_test {
namespace {

constexpr std::size_t kBins = 65;

/// Exponentially distributed powers, as the bins of white noise have.
class WhiteNoise {
 public:
  std::vector<float> operator()(float mean) {
    std::vector<float> power(kBins);
    for (float& p : power) p = mean * exponential_(random_);
    return power;
  }

 private:
  std::mt19937 random_{5};
  std::exponential_distribution<float> exponential_{1};
};

float mean(std::span<const float> values) {
  float sum = 0;
  for (const float v : values) sum += v;
  return sum / static_cast<float>(values.size());
}

// The window of ODAS has a wrong sign and an uninitialised sum (fault B1).
TEST(Mcra, smooths_over_frequency_with_a_Hann_window_of_sum_one) {
  McraConfig config;
  config.alpha_s = 1;  // S is Sf, and a minimum of one hop: the estimate follows P where S is small
  config.b = 3;
  Mcra mcra(config, 1, 5);
  // After one hop psd = P. Later an S can be told from what the estimate refuses: S >= delta Smin.
  mcra.update(0, std::vector<float>{1, 1, 1, 1, 1});
  // Sf of a peak of 8 in the middle: 1 + 7 * {0, 1/4, 1/2, 1/4, 0} = 1, 2.75, 4.5, 2.75, 1; delta is 3.
  mcra.update(0, std::vector<float>{1, 1, 8, 1, 1});
  EXPECT_FLOAT_EQ(mcra.psd()[0][2], 1);
  // Bin 1: 0.5 * 1.4 + 0.25 * (1 + 8) = 2.95 < 3 is noise; with 9 in the middle it is 3.2, and is not.
  mcra.update(0, std::vector<float>{1, 1.4F, 8, 1, 1});
  EXPECT_FLOAT_EQ(mcra.psd()[0][1], 1.04F);
  mcra.update(0, std::vector<float>{1, 1.4F, 9, 1, 1});
  EXPECT_FLOAT_EQ(mcra.psd()[0][1], 1.04F);
}

TEST(Mcra, mirrors_at_the_first_and_last_bin) {
  McraConfig config;
  config.alpha_s = 1;
  config.b = 3;
  Mcra mcra(config, 1, 4);
  mcra.update(0, std::vector<float>{1, 1, 1, 1});
  // Bin 0: half itself, a quarter of bin 1 twice: 0.5 * 1 + 0.5 * 5.4 = 3.2 >= 3: speech.
  mcra.update(0, std::vector<float>{1, 5.4F, 1, 1});
  EXPECT_FLOAT_EQ(mcra.psd()[0][0], 1);
  EXPECT_FLOAT_EQ(mcra.psd()[0][3], 1);
  // 0.5 * 1 + 0.5 * 4.6 = 2.8 < 3: noise. It is 2 in bin 0 that is taken in.
  mcra.update(0, std::vector<float>{1.4F, 4.2F, 1, 1});
  EXPECT_FLOAT_EQ(mcra.psd()[0][0], 1.04F);
}

TEST(Mcra, finds_the_power_of_white_noise) {
  WhiteNoise noise;
  Mcra mcra({}, 1, kBins);
  for (int hop = 0; hop < 1000; ++hop) mcra.update(0, noise(4));
  EXPECT_NEAR(mean(mcra.psd()[0]), 4, 0.8);
}

// ODAS's estimate is zero for 303 hops.
TEST(Mcra, has_an_estimate_from_the_first_sound_on) {
  WhiteNoise noise;
  Mcra mcra({}, 1, kBins);
  const std::vector<float> silence(kBins);
  for (int hop = 0; hop < 20; ++hop) mcra.update(0, silence);
  EXPECT_EQ(mean(mcra.psd()[0]), 0);
  mcra.update(0, noise(4));
  EXPECT_GT(mean(mcra.psd()[0]), 2);
  for (int hop = 0; hop < 20; ++hop) mcra.update(0, noise(4));
  EXPECT_NEAR(mean(mcra.psd()[0]), 4, 1);
}

TEST(Mcra, does_not_take_a_burst_of_speech_for_noise) {
  WhiteNoise noise;
  Mcra mcra({}, 1, kBins);
  for (int hop = 0; hop < 200; ++hop) mcra.update(0, noise(1));
  for (int hop = 0; hop < 60; ++hop) mcra.update(0, noise(100));
  EXPECT_LT(mean(mcra.psd()[0]), 8);
}

TEST(Mcra, learns_a_noise_that_stays_louder_within_two_periods) {
  WhiteNoise noise;
  Mcra mcra({}, 1, kBins);
  for (int hop = 0; hop < 200; ++hop) mcra.update(0, noise(1));
  for (int hop = 0; hop < 2 * 152 + 60; ++hop) mcra.update(0, noise(100));
  EXPECT_NEAR(mean(mcra.psd()[0]), 100, 25);
}

TEST(Mcra, falls_at_once_when_the_noise_does) {
  WhiteNoise noise;
  Mcra mcra({}, 1, kBins);
  for (int hop = 0; hop < 200; ++hop) mcra.update(0, noise(100));
  for (int hop = 0; hop < 80; ++hop) mcra.update(0, noise(1));
  EXPECT_LT(mean(mcra.psd()[0]), 2);
}

TEST(Mcra, scales_with_its_input) {
  WhiteNoise one;
  WhiteNoise same;
  Mcra quiet({}, 1, kBins);
  Mcra loud({}, 1, kBins);
  for (int hop = 0; hop < 400; ++hop) {
    quiet.update(0, one(1));
    loud.update(0, same(1024));
  }
  for (std::size_t k = 0; k < kBins; ++k) EXPECT_FLOAT_EQ(loud.psd()[0][k], 1024 * quiet.psd()[0][k]);
}

TEST(Mcra, takes_the_powers_of_spectra) {
  Mcra by_spectra({}, 2, kBins);
  Mcra by_power({}, 2, kBins);
  Grid<cfloat> spectra(2, kBins);
  spectra[0][3] = {3, 4};
  spectra[1][9] = {0, 2};
  std::vector<float> power(kBins);
  by_spectra.update(spectra);
  power[3] = 25;
  by_power.update(0, power);
  EXPECT_EQ(by_spectra.psd()[0][3], by_power.psd()[0][3]);
  EXPECT_EQ(by_spectra.psd()[0][3], 25);
  EXPECT_EQ(by_spectra.psd()[1][9], 4);
}

TEST(Mcra, keeps_its_estimate_through_a_hop_that_is_not_finite) {
  WhiteNoise noise;
  WhiteNoise same;
  Mcra hurt({}, 1, kBins);
  Mcra whole({}, 1, kBins);
  for (int hop = 0; hop < 100; ++hop) {
    if (hop == 50) {
      std::vector<float> bad(kBins, 1);
      bad[7] = std::numeric_limits<float>::quiet_NaN();
      hurt.update(0, bad);
      bad[7] = std::numeric_limits<float>::infinity();
      hurt.update(0, bad);
    }
    hurt.update(0, noise(1));
    whole.update(0, same(1));
  }
  for (std::size_t k = 0; k < kBins; ++k) EXPECT_EQ(hurt.psd()[0][k], whole.psd()[0][k]);
}

TEST(Mcra, after_reset_is_as_new_channel_by_channel) {
  WhiteNoise noise;
  Mcra mcra({}, 2, kBins);
  for (int hop = 0; hop < 300; ++hop) {
    mcra.update(0, noise(1));
    mcra.update(1, noise(9));
  }
  const std::vector<float> other(mcra.psd()[1].begin(), mcra.psd()[1].end());
  mcra.reset(0);
  Mcra fresh({}, 1, kBins);
  WhiteNoise one;
  WhiteNoise same;
  for (int hop = 0; hop < 300; ++hop) {
    mcra.update(0, one(2));
    fresh.update(0, same(2));
  }
  for (std::size_t k = 0; k < kBins; ++k) {
    EXPECT_EQ(mcra.psd()[0][k], fresh.psd()[0][k]);
    EXPECT_EQ(mcra.psd()[1][k], other[k]);
  }
}

TEST(Mcra, begins_from_what_is_known_of_the_noise) {
  Mcra mcra({}, 1, kBins);
  mcra.reset(0, std::vector<float>(kBins, 3));
  EXPECT_EQ(mcra.psd()[0][5], 3);
  mcra.update(0, std::vector<float>(kBins, 1000));  // speech from the first hop on
  EXPECT_EQ(mcra.psd()[0][5], 3);
  mcra.reset(0, std::vector<float>(kBins, std::numeric_limits<float>::infinity()));
  EXPECT_EQ(mcra.psd()[0][5], 0);
}

}  // namespace
}  // namespace odas::mcra_test
