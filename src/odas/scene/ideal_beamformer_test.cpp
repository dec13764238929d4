// SPDX-License-Identifier: MIT
#include "odas/scene/ideal_beamformer.hpp"

#include <gtest/gtest.h>

#include "odas/scene/noise.hpp"
#include "odas/scene/projection.hpp"

namespace odas::ideal_beamformer_test {
namespace {

constexpr std::size_t kSamples = 32000;

/// A plane wave at `late` samples from microphone to microphone.
Grid<float> wave(std::size_t mics, std::size_t late, std::uint32_t seed) {
  const auto sound = point_noise(NoiseColour::pink, kSamples, 16000, seed);
  Grid<float> image(mics, kSamples);
  for (std::size_t m = 0; m < mics; ++m) {
    for (std::size_t n = m * late; n < kSamples; ++n) image[m][n] = sound[n - m * late];
  }
  return image;
}

Grid<float> sum(const Grid<float>& a, const Grid<float>& b) {
  Grid<float> both = a;
  for (std::size_t m = 0; m < a.rows(); ++m) {
    for (std::size_t n = 0; n < a.cols(); ++n) both[m][n] += b[m][n];
  }
  return both;
}

TEST(IdealBeamformer, Leaves_a_talker_who_is_alone_as_he_is) {
  const Grid<float> alone = wave(3, 2, 1);
  const auto voice = ideal_beamformer_voice(alone, alone);
  EXPECT_GT(si_sdr_db(voice, alone[0]), 40);
}

TEST(IdealBeamformer, Nulls_another_talker_and_no_more_with_one_microphone_than_a_filter_can) {
  const Grid<float> talker = wave(3, 2, 1), other = wave(3, 5, 2);
  const auto voice = ideal_beamformer_voice(sum(talker, other), talker);
  EXPECT_GT(si_sdr_db(voice, talker[0]), 10);  // the lowest sounds part by no more
  const Grid<float> one = wave(1, 0, 1), two = wave(1, 0, 2);
  EXPECT_NEAR(si_sdr_db(ideal_beamformer_voice(sum(one, two), one), one[0]), 0, 1);
}

TEST(IdealBeamformer, Means_over_the_talkers_and_says_nothing_where_nobody_talks) {
  const std::vector<Grid<float>> images{wave(3, 2, 1), wave(3, 5, 2)};
  const Grid<float> mics = sum(images[0], images[1]);
  const auto sdr = ideal_beamformer_sdr_db(mics, images);
  ASSERT_TRUE(sdr);
  EXPECT_GT(*sdr, 15);
  EXPECT_FALSE(ideal_beamformer_sdr_db(mics, {}));
}

}  // namespace
}  // namespace odas::ideal_beamformer_test
