// SPDX-License-Identifier: MIT
#include "odas/scene/projection.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "odas/scene/correlation.hpp"

namespace odas::projection_test {
namespace {

constexpr std::size_t kSamples = 48000;

std::vector<float> noise(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> x(kSamples);
  for (float& v : x) v = static_cast<float>(random() % 20001) / 10000 - 1;
  return x;
}

std::vector<float> sum(const std::vector<float>& a, float gain, const std::vector<float>& b) {
  std::vector<float> out(a);
  for (std::size_t n = 0; n < out.size(); ++n) out[n] += gain * b[n];
  return out;
}

/// A short room: a few paths, some of them ahead of the first microphone.
std::vector<float> elsewhere(const std::vector<float>& x) {
  std::vector<double> taps(200);
  taps[3] = 0.8;
  taps[40] = -0.5;
  taps[41] = 0.2;
  taps[170] = 0.3;
  return filter(x, taps, 50);
}

TEST(SolveToeplitz, gives_what_the_matrix_brings_back) {
  std::vector<double> row(40);
  std::vector<double> wanted(40);
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = std::pow(0.8, static_cast<double>(i)) * std::cos(0.9 * static_cast<double>(i));
    wanted[i] = std::sin(static_cast<double>(i * i));
  }
  std::vector<double> y(40, 0.0);
  for (std::size_t i = 0; i < 40; ++i) {
    for (std::size_t j = 0; j < 40; ++j) y[i] += row[i > j ? i - j : j - i] * wanted[j];
  }
  const auto x = solve_toeplitz(row, y);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(x[i], wanted[i], 1e-10);
}

TEST(Sdr, does_not_count_a_short_filter_as_distortion_but_noise) {
  const auto target = noise(1);
  const auto heard = elsewhere(target);
  // Power of `heard`: 0.64 + 0.25 + 0.04 + 0.09 = 1.02 of the target's; of the noise added: 0.01.
  const double expected = 10 * std::log10(1.02 / 0.01);
  // 512 taps explain 512 / 48000 of the noise too: 0.05 dB.
  EXPECT_NEAR(sdr_db(sum(heard, 0.1F, noise(2)), target), expected, 0.15);
  EXPECT_GT(sdr_db(heard, target), 50);
}

TEST(SiSdr, does_not_see_the_scale_but_the_filter) {
  const auto target = noise(1);
  const auto noisy = sum(target, 0.1F, noise(2));
  EXPECT_NEAR(si_sdr_db(noisy, target), 20, 0.15);
  auto louder = noisy;
  for (float& v : louder) v *= 7;
  EXPECT_NEAR(si_sdr_db(louder, target), si_sdr_db(noisy, target), 1e-3);
  EXPECT_LT(si_sdr_db(elsewhere(target), target), -20);
}

TEST(Sir, counts_other_talkers_through_any_short_filter_and_no_noise) {
  const auto target = noise(1);
  const std::vector<std::vector<float>> others{noise(2), noise(3)};
  auto heard = sum(elsewhere(target), 0.2F, elsewhere(others[0]));
  heard = sum(heard, 0.1F, others[1]);
  const double expected = 10 * std::log10(1.02 / (0.04 * 1.02 + 0.01));
  EXPECT_NEAR(sir_db(heard, target, others), expected, 0.2);
  EXPECT_NEAR(sir_db(sum(heard, 0.3F, noise(4)), target, others), expected, 0.5);
}

TEST(Sir, is_infinite_where_nobody_else_speaks) {
  const auto target = noise(1);
  EXPECT_TRUE(std::isinf(sir_db(target, target, {})));
  const std::vector<std::vector<float>> silent{std::vector<float>(kSamples, 0.F)};
  EXPECT_TRUE(std::isinf(sir_db(target, target, silent)));
}

TEST(Projection, of_silence_is_a_number) {
  const std::vector<float> silent(kSamples, 0.F);
  const auto sound = noise(1);
  EXPECT_TRUE(std::isfinite(sdr_db(silent, sound)));
  EXPECT_TRUE(std::isfinite(sdr_db(sound, silent)));
  EXPECT_TRUE(std::isfinite(si_sdr_db(silent, sound)));
  EXPECT_TRUE(std::isfinite(si_sdr_db(sound, silent)));
}

}  // namespace
}  // namespace odas::projection_test
