// SPDX-License-Identifier: MIT
#include "odas/classification/pitch.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace odas::pitch_test {
namespace {

/// A sound of ten harmonics, such as a voice has, whose period is `period` samples.
std::vector<float> harmonics(std::size_t size, double period, double level = 0.1) {
  std::vector<float> out(size);
  for (std::size_t n = 0; n < size; ++n) {
    double x = 0;
    for (int h = 1; h <= 10; ++h) x += std::cos(2 * M_PI * h * static_cast<double>(n) / period + h * h) / h;
    out[n] = static_cast<float>(level * x);
  }
  return out;
}

std::vector<float> white_noise(std::size_t size, float level, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0, level);
  std::vector<float> out(size);
  for (float& x : out) x = normal(random);
  return out;
}

TEST(PitchDetector, finds_the_period_to_a_fifth_of_a_sample) {
  PitchDetector detector(1024, 3, 0.35F);
  for (const double period : {33.0, 57.3, 80.5, 111.1, 160.0, 199.7}) {
    EXPECT_NEAR(detector.period(harmonics(1024, period)), period, 0.2) << period;
  }
}

TEST(PitchDetector, does_not_depend_on_the_level) {
  PitchDetector detector(1024, 3, 0.35F);
  const float loud = detector.period(harmonics(1024, 90, 1));
  EXPECT_NEAR(detector.period(harmonics(1024, 90, 1e-4)), loud, 1e-3);
}

TEST(PitchDetector, finds_a_period_through_noise_of_half_its_level) {
  PitchDetector detector(1024, 3, 0.35F);
  auto frame = harmonics(1024, 80, 0.1);
  const auto noise = white_noise(1024, 0.04F);
  for (std::size_t n = 0; n < frame.size(); ++n) frame[n] += noise[n];
  EXPECT_NEAR(detector.period(frame), 80, 0.5);
}

TEST(PitchDetector, finds_none_in_noise_and_silence) {
  PitchDetector detector(1024, 3, 0.35F);
  for (unsigned seed = 0; seed < 100; ++seed) {
    EXPECT_EQ(detector.period(white_noise(1024, 0.1F, seed)), 0) << seed;
  }
  EXPECT_EQ(detector.period(std::vector<float>(1024)), 0);
}

TEST(PitchDetector, takes_any_peak_where_no_voicing_is_asked_for) {
  PitchDetector detector(1024, 3, 0);
  EXPECT_GT(detector.period(white_noise(1024, 0.1F)), 0);
}

}  // namespace
}  // namespace odas::pitch_test
