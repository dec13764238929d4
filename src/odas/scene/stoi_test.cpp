// SPDX-License-Identifier: MIT
#include "odas/scene/stoi.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "odas/scene/noise.hpp"
#include "odas/scene/random.hpp"

namespace odas::stoi_test {
namespace {

/// Noise whose level goes up and down four times a second, as syllables do.
std::vector<float> syllables(std::uint32_t seed) {
  auto sound = point_noise(NoiseColour::pink, 48000, 16000, seed);
  Random random(seed);
  float level = 0, wanted = 1;
  for (std::size_t n = 0; n < sound.size(); ++n) {
    if (n % 2000 == 0) wanted = random.share();
    level += 0.005F * (wanted * wanted - level);
    sound[n] *= level;
  }
  return sound;
}

std::vector<float> with_noise(std::vector<float> sound, float snr_db, std::uint32_t seed) {
  const auto noise = point_noise(NoiseColour::pink, sound.size(), 16000, seed);
  double power = 0;
  for (const float x : sound) power += static_cast<double>(x) * x;
  const auto rms = static_cast<float>(std::sqrt(power / static_cast<double>(sound.size())));
  for (std::size_t n = 0; n < sound.size(); ++n) sound[n] += rms * std::pow(10.F, -snr_db / 20) * noise[n];
  return sound;
}

TEST(Stoi, Of_the_clean_speech_itself_is_1_however_loud) {
  const auto clean = syllables(1);
  auto louder = clean;
  for (float& x : louder) x *= 30;
  ASSERT_TRUE(stoi(clean, clean, 16000));
  EXPECT_NEAR(*stoi(clean, clean, 16000), 1, 1e-6);
  EXPECT_NEAR(*stoi(clean, louder, 16000), 1, 1e-4);
}

TEST(Stoi, Falls_with_the_noise_and_is_low_for_other_speech) {
  const auto clean = syllables(1);
  double last = 1;
  for (const float snr : {20.F, 10.F, 0.F, -10.F}) {
    const auto found = stoi(clean, with_noise(clean, snr, 9), 16000);
    ASSERT_TRUE(found);
    EXPECT_LT(*found, last) << snr << " dB";
    last = *found;
  }
  EXPECT_LT(last, 0.5);
  EXPECT_LT(*stoi(clean, syllables(2), 16000), 0.4);
}

TEST(Stoi, Silence_before_and_behind_the_words_does_not_count) {
  const auto clean = syllables(1);
  const auto noisy = with_noise(clean, 0, 9);
  auto padded = clean, padded_noisy = noisy;
  padded.insert(padded.begin(), 16000, 0.F);
  padded_noisy.insert(padded_noisy.begin(), 16000, 0.5F);
  EXPECT_NEAR(*stoi(padded, padded_noisy, 16000), *stoi(clean, noisy, 16000), 0.02);
}

TEST(Stoi, Of_less_than_a_stretch_of_speech_is_unknown) {
  EXPECT_FALSE(stoi(std::vector<float>(3000, 0.1F), std::vector<float>(3000, 0.1F), 16000));
  EXPECT_FALSE(stoi({}, {}, 16000));
}

}  // namespace
}  // namespace odas::stoi_test
