// SPDX-License-Identifier: MIT
#include "odas/scene/score.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace odas::score_test {
namespace {

constexpr std::size_t kHops = 250;  // 2 s

KnownScene one_talker() {
  KnownScene scene;
  scene.hops = kHops;
  scene.sources.push_back({std::vector<Direction>(kHops, {1, 0, 0}), std::vector<std::uint8_t>(kHops, 1)});
  return scene;
}

/// Right in azimuth, 30 degrees too high.
Audition heard_too_high() {
  Audition audition;
  const Direction high{std::cos(M_PI / 6), 0, 0.5};
  audition.potentials.emplace();
  for (std::size_t h = 0; h < kHops; ++h) {
    audition.tracks.push_back({h, {{0, 1, high}}});
    audition.potentials->push_back({h, high});
  }
  return audition;
}

TEST(Score, has_every_figure_by_azimuth_and_by_angle) {
  const Score result = score(one_talker(), std::nullopt, heard_too_high());
  EXPECT_DOUBLE_EQ(result.seconds, 2);
  EXPECT_EQ(result.sources, 1U);
  EXPECT_EQ(*result.azimuth.tracks.recall, 1);
  EXPECT_EQ(*result.angle.tracks.recall, 0);
  EXPECT_NEAR(*result.azimuth.potentials.median_deg, 0, 1e-9);
  EXPECT_NEAR(*result.angle.potentials.median_deg, 30, 1e-9);
  EXPECT_NEAR(result.azimuth.ospa_deg, 0, 1e-9);
  EXPECT_NEAR(result.angle.ospa_deg, 30, 1e-9);
}

TEST(Score, takes_the_voice_of_the_track_that_is_right_in_azimuth) {
  KnownSound sound;
  sound.mic.resize(kHops * 128);
  for (std::size_t n = 0; n < sound.mic.size(); ++n) {
    sound.mic[n] = std::sin(static_cast<float>(n % 997) * static_cast<float>(n % 991));
  }
  sound.images = {sound.mic};
  Audition audition = heard_too_high();
  audition.separated = [&](std::size_t hop, const HeardTrack&, std::span<float> out) {
    std::copy_n(sound.mic.begin() + static_cast<long>(hop * 128), 128, out.begin());
  };
  const Score result = score(one_talker(), sound, audition);
  ASSERT_TRUE(result.separated.has_value());
  EXPECT_GT(result.separated->sdr, 50);
  EXPECT_FALSE(result.separated->sir.has_value());
  EXPECT_FALSE(result.postfiltered.has_value());
}

}  // namespace
}  // namespace odas::score_test
