// SPDX-License-Identifier: MIT
#include "odas/scene/activity.hpp"

#include <gtest/gtest.h>

#include "odas/scene/random.hpp"

namespace odas::activity_test {
namespace {

constexpr int kRate = 16000;
constexpr std::size_t kStep = 160;  // 10 ms

/// Noise from `begin` to `end` seconds.
void put(std::vector<float>& sound, double begin, double end, float gain = 1) {
  Random random(1);
  for (auto n = static_cast<std::size_t>(begin * kRate); n < static_cast<std::size_t>(end * kRate); ++n) {
    sound[n] = gain * random.uniform();
  }
}

TEST(Activity, Begins_and_ends_with_the_sound_within_10_ms) {
  std::vector<float> sound(2 * kRate);
  put(sound, 0.5, 1.5);
  const auto active = activity_of(sound, kStep, kRate);
  ASSERT_EQ(active.size(), 200U);
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (i < 49 || i > 150) {
      EXPECT_FALSE(active[i]) << i;
    } else if (i > 50 && i < 149) {
      EXPECT_TRUE(active[i]) << i;
    }
  }
}

TEST(Activity, Goes_on_over_short_pauses_and_not_over_long_ones) {
  std::vector<float> sound(3 * kRate);
  put(sound, 0.5, 1);
  put(sound, 1.15, 1.5);
  put(sound, 2, 2.5);
  const auto active = activity_of(sound, kStep, kRate);
  EXPECT_TRUE(active[107]);
  EXPECT_FALSE(active[175]);
}

TEST(Activity, Of_a_sound_shorter_than_a_pause_is_all_of_it) {
  for (const double seconds : {0.01, 0.1, 0.19}) {
    std::vector<float> sound(static_cast<std::size_t>(seconds * kRate));
    put(sound, 0, seconds);
    for (const auto active : activity_of(sound, kStep, kRate)) EXPECT_TRUE(active) << seconds;
  }
}

TEST(Activity, Does_not_count_what_is_40_dB_under_the_loud_parts) {
  std::vector<float> sound(3 * kRate);
  put(sound, 0, 1);
  put(sound, 1, 3, 0.01F);
  const auto active = activity_of(sound, kStep, kRate);
  EXPECT_TRUE(active[50]);
  EXPECT_FALSE(active[200]);
}

TEST(Activity, Of_silence_is_none_and_scale_does_not_matter) {
  std::vector<float> sound(2 * kRate);
  for (const auto active : activity_of(sound, kStep, kRate)) EXPECT_FALSE(active);
  put(sound, 0.3, 1);
  std::vector<float> quiet = sound;
  for (float& x : quiet) x *= 0.0625F;
  EXPECT_EQ(activity_of(sound, kStep, kRate), activity_of(quiet, kStep, kRate));
}

}  // namespace
}  // namespace odas::activity_test
