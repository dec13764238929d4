// SPDX-License-Identifier: MIT
#include "odas/scene/ideal_mask.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "odas/scene/noise.hpp"
#include "odas/scene/projection.hpp"

namespace odas::ideal_mask_test {
namespace {

std::vector<float> sine(double hertz) {
  std::vector<float> sound(16000);
  for (std::size_t n = 0; n < sound.size(); ++n) {
    sound[n] =
        static_cast<float>(0.1 * std::sin(2 * std::numbers::pi * hertz * static_cast<double>(n) / 16000));
  }
  return sound;
}

std::vector<float> sum(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<float> both = a;
  for (std::size_t n = 0; n < both.size(); ++n) both[n] += b[n];
  return both;
}

TEST(IdealMask, Leaves_a_talker_who_is_alone_as_he_is) {
  const auto alone = point_noise(NoiseColour::pink, 16000, 16000, 1);
  const auto voice = ideal_mask_voice(alone, alone);
  for (std::size_t n = 0; n < alone.size(); ++n) EXPECT_NEAR(voice[n], alone[n], 1e-4);
}

TEST(IdealMask, Parts_tones_that_are_far_from_each_other) {
  const auto low = sine(500), high = sine(3000);
  const auto voice = ideal_mask_voice(sum(low, high), low);
  EXPECT_GT(si_sdr_db(voice, low), 25);
  EXPECT_NEAR(si_sdr_db(sum(low, high), low), 0, 0.5);
}

TEST(IdealMask, Gains_some_but_not_all_in_noise) {
  const auto a = point_noise(NoiseColour::pink, 16000, 16000, 1),
             b = point_noise(NoiseColour::pink, 16000, 16000, 2);
  const KnownSound sound{sum(a, b), {a, b}};
  const auto sdr = ideal_mask_sdr_db(sound);
  ASSERT_TRUE(sdr);
  EXPECT_GT(*sdr, 3);
  EXPECT_LT(*sdr, 15);
  EXPECT_FALSE(ideal_mask_sdr_db({a, {}}));
}

}  // namespace
}  // namespace odas::ideal_mask_test
