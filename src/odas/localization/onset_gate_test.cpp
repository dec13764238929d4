// SPDX-License-Identifier: MIT
#include "odas/localization/onset_gate.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace odas::onset_gate_test {
namespace {

constexpr std::size_t kMics = 4;  // for which c = 3
constexpr std::size_t kBins = 129;
constexpr float kHop = 0.008F;
constexpr float kBinHz = 62.5F;
constexpr std::size_t kTop = kBins - 1;

struct Gate {
  std::span<const float> hop(float amplitude, float noise = 0) {
    for (std::size_t m = 0; m < kMics; ++m) {
      for (cfloat& x : spectra[m]) x = amplitude;
      for (float& n : psd[m]) n = noise;
    }
    gate.update(spectra, psd);
    return gate.weights();
  }
  OnsetGate gate{kMics, kBins, kHop, kBinHz};
  Grid<cfloat> spectra{kMics, kBins};
  Grid<float> psd{kMics, kBins};
};

TEST(OnsetGate, Counts_clear_bins_by_their_frequency_and_none_under_200_Hz) {
  Gate g;
  const auto w = g.hop(5);
  EXPECT_EQ(w[0], 0);
  EXPECT_EQ(w[3], 0);
  EXPECT_FLOAT_EQ(w[32], 0.25F);
  EXPECT_FLOAT_EQ(w[kTop], 1);
}

TEST(OnsetGate, Takes_three_times_the_noise_off) {
  Gate g;
  EXPECT_FLOAT_EQ(g.hop(2, 0.5F)[kTop], 1 - 3 * 0.5F / 4);
  g.gate.reset();
  EXPECT_EQ(g.hop(2, 1.5F)[kTop], 0);
}

TEST(OnsetGate, Hears_no_echo_that_decays_by_60_dB_in_half_a_second) {
  Gate g;
  g.hop(1);
  for (int hop = 1; hop < 30; ++hop) {
    const float as_an_echo = std::pow(10.F, -3 * kHop * static_cast<float>(hop) / 0.5F);
    EXPECT_LT(g.hop(as_an_echo)[kTop], 1e-4F) << hop;
  }
  EXPECT_GT(g.hop(1)[kTop], 0.9F) << "a new onset";
}

TEST(OnsetGate, Lets_hardly_anything_of_steady_noise_through) {
  Gate g;
  std::mt19937 random(1);
  std::normal_distribution<float> normal(0, std::sqrt(0.5F));
  double passed = 0;
  constexpr int kHops = 300;
  for (int hop = 0; hop < kHops; ++hop) {
    for (std::size_t m = 0; m < kMics; ++m) {
      for (std::size_t k = 0; k < kBins; ++k) {
        // One noise in all microphones: its power spreads the most.
        g.spectra[m][k] = m == 0 ? cfloat{normal(random), normal(random)} : g.spectra[0][k];
        g.psd[m][k] = 1;
      }
    }
    g.gate.update(g.spectra, g.psd);
    passed += g.gate.weights()[100] / (100.F / 128);
  }
  EXPECT_LT(passed / kHops, 0.02) << "e^-3 of the hops exceed the noise by so much, and by little";
}

TEST(OnsetGate, Is_deaf_to_a_bin_that_is_not_finite_and_forgets_it) {
  Gate g;
  Gate fresh;
  g.spectra[1][50] = {std::numeric_limits<float>::quiet_NaN(), 0};
  g.spectra[0][60] = {std::numeric_limits<float>::infinity(), 0};
  g.gate.update(g.spectra, g.psd);
  for (const float w : g.gate.weights()) EXPECT_EQ(w, 0);
  EXPECT_EQ(g.hop(1)[50], fresh.hop(1)[50]);
  EXPECT_EQ(g.hop(1)[60], fresh.hop(1)[60]);
}

}  // namespace
}  // namespace odas::onset_gate_test
