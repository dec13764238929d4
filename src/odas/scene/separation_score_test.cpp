// SPDX-License-Identifier: MIT
#include "odas/scene/separation_score.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace odas::separation_score_test {
namespace {

constexpr std::size_t kHop = 128;
constexpr std::size_t kHops = 500;  // 4 s

std::vector<float> noise(unsigned seed, float gain) {
  std::mt19937 random(seed);
  std::vector<float> x(kHops * kHop);
  for (float& v : x) v = gain * (static_cast<float>(random() % 20001) / 10000 - 1);
  return x;
}

/// Two talkers as loud as each other; the microphone hears both.
class TwoVoices : public ::testing::Test {
 protected:
  TwoVoices() {
    scene_.hops = kHops;
    scene_.sources.resize(2);
    sound_.images = {noise(1, 0.1F), noise(2, 0.1F)};
    // A late voice is cut at its end: nobody speaks there.
    for (auto& image : sound_.images) std::fill(image.end() - 1000, image.end(), 0.F);
    sound_.mic = sound_.images[0];
    for (std::size_t n = 0; n < sound_.mic.size(); ++n) sound_.mic[n] += sound_.images[1][n];
    followed_.assign(2, std::vector<HeardTrack>(kHops));
  }

  void follow(std::size_t source, std::size_t from, std::size_t to) {
    for (std::size_t h = from; h < to; ++h) followed_[source][h] = {source, source + 1, {}};
  }

  /// The talker of the slot, `late` samples behind, and this much of the other.
  [[nodiscard]] VoiceOf system(std::size_t late, float other) const {
    return [this, late, other](std::size_t hop, const HeardTrack& track, std::span<float> out) {
      for (std::size_t n = 0; n < out.size(); ++n) {
        const std::size_t at = hop * kHop + n;
        out[n] = at < late ? 0
                           : sound_.images[track.slot][at - late] +
                                 other * sound_.images[1 - track.slot][at - late];
      }
    };
  }

  KnownScene scene_;
  KnownSound sound_;
  std::vector<std::vector<HeardTrack>> followed_;
};

TEST_F(TwoVoices, are_scored_beside_the_microphone_and_late_or_not) {
  follow(0, 0, kHops);
  follow(1, 0, kHops);
  for (const std::size_t late : {0U, 391U}) {
    const auto score = score_separation(scene_, sound_, followed_, system(late, 0.1F));
    ASSERT_TRUE(score.has_value());
    // 512 taps of 64000 samples explain a little of the other talker as well: 0.04 dB at 0 dB.
    EXPECT_NEAR(score->sdr, 20, 0.1);
    EXPECT_NEAR(score->sdr_in, 0, 0.1);
    EXPECT_NEAR(score->si_sdr, 20, 0.1);
    EXPECT_NEAR(score->si_sdr_in, 0, 0.1);
    EXPECT_NEAR(*score->sir, 20, 0.2);
    EXPECT_NEAR(*score->sir_in, 0, 0.1);
  }
}

TEST_F(TwoVoices, count_only_while_they_are_followed) {
  follow(0, 100, 300);
  const auto perfect = system(0, 0);
  const auto score = score_separation(scene_, sound_, followed_,
                                      [&](std::size_t hop, const HeardTrack& track, std::span<float> out) {
                                        EXPECT_TRUE(hop >= 100 && hop < 300 && track.id == 1);
                                        perfect(hop, track, out);
                                      });
  ASSERT_TRUE(score.has_value());
  EXPECT_GT(score->sdr, 50);
  EXPECT_NEAR(score->sdr_in, 0, 0.2);
}

TEST_F(TwoVoices, are_left_out_when_followed_for_less_than_a_second) {
  follow(1, 0, 124);
  EXPECT_FALSE(score_separation(scene_, sound_, followed_, system(0, 0)).has_value());
}

TEST_F(TwoVoices, have_no_interference_when_one_is_silent) {
  follow(0, 0, kHops);
  std::ranges::fill(sound_.images[1], 0.F);
  const auto score = score_separation(scene_, sound_, followed_, system(0, 0));
  ASSERT_TRUE(score.has_value());
  EXPECT_FALSE(score->sir.has_value());
}

}  // namespace
}  // namespace odas::separation_score_test
