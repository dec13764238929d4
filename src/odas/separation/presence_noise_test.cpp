// SPDX-License-Identifier: MIT
#include "odas/separation/presence_noise.hpp"

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

namespace odas::presence_noise_test {
namespace {

constexpr float kHop = 0.008F;

/// A noise of power 1 as spectra have it: exponentially distributed.
class Noise {
 public:
  std::vector<float> next(float level) {
    std::vector<float> power(200);
    for (float& p : power) p = level * distribution_(random_);
    return power;
  }

 private:
  std::mt19937 random_{1};
  std::exponential_distribution<float> distribution_{1};
};

float mean(std::span<const float> values) {
  float sum = 0;
  for (const float value : values) sum += value;
  return sum / static_cast<float>(values.size());
}

TEST(PresenceNoise, knows_a_steady_noise_within_a_decibel) {
  PresenceNoise noise(200, kHop);
  Noise source;
  for (int hop = 0; hop < 300; ++hop) noise.update(source.next(4));
  EXPECT_NEAR(10 * std::log10(mean(noise.power()) / 4), 0, 1);
}

TEST(PresenceNoise, does_not_learn_a_word) {
  PresenceNoise noise(200, kHop);
  Noise source;
  for (int hop = 0; hop < 200; ++hop) noise.update(source.next(1));
  for (int hop = 0; hop < 25; ++hop) noise.update(source.next(100));  // 0.2 s
  EXPECT_LT(mean(noise.power()), 2.5F);
}

TEST(PresenceNoise, follows_a_noise_that_became_louder) {
  PresenceNoise noise(200, kHop);
  Noise source;
  for (int hop = 0; hop < 200; ++hop) noise.update(source.next(1));
  for (int hop = 0; hop < 500; ++hop) noise.update(source.next(10));
  EXPECT_NEAR(10 * std::log10(mean(noise.power())), 10, 1.5);
}

TEST(PresenceNoise, goes_on_from_another_and_is_new_after_a_reset) {
  PresenceNoise noise(200, kHop), other(200, kHop);
  Noise source;
  for (int hop = 0; hop < 200; ++hop) noise.update(source.next(1));
  other.take_over(noise);
  EXPECT_EQ(std::vector<float>(other.power().begin(), other.power().end()),
            std::vector<float>(noise.power().begin(), noise.power().end()));
  noise.reset();
  PresenceNoise fresh(200, kHop);
  const auto power = source.next(1);
  noise.update(power);
  fresh.update(power);
  EXPECT_EQ(std::vector<float>(fresh.power().begin(), fresh.power().end()),
            std::vector<float>(noise.power().begin(), noise.power().end()));
}

}  // namespace
}  // namespace odas::presence_noise_test
