// SPDX-License-Identifier: MIT
#include "odas/scene/noise.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "odas/dsp/real_fft.hpp"

namespace odas::noise_test {
namespace {

Scene pair_of_mics(float distance) {
  Scene scene;
  scene.seconds = 16;
  scene.mics = {{{0, 0, 0}, {0, 0, 1}, 1}, {{distance, 0, 0}, {0, 0, 1}, 1}};
  return scene;
}

/// Real part of the coherence of two channels at `hertz`, over frames of 256 and bins within 3.
double coherence(const Grid<float>& x, double hertz) {
  constexpr std::size_t kFrame = 256;
  RealFft fft(kFrame);
  const auto centre = static_cast<std::size_t>(std::lround(hertz / 16000 * kFrame));
  double cross = 0, a = 0, b = 0;
  for (std::size_t start = 0; start + kFrame <= x.cols(); start += kFrame / 2) {
    std::array<std::array<cfloat, 7>, 2> bins{};
    for (std::size_t m = 0; m < 2; ++m) {
      for (std::size_t n = 0; n < kFrame; ++n) {
        const double hann = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(n) / kFrame);
        fft.time()[n] = static_cast<float>(hann) * x[m][start + n];
      }
      fft.forward();
      for (std::size_t k = 0; k < 7; ++k) bins[m][k] = fft.bins()[centre + k - 3];
    }
    for (std::size_t k = 0; k < 7; ++k) {
      cross += static_cast<double>((bins[0][k] * std::conj(bins[1][k])).real());
      a += static_cast<double>(std::norm(bins[0][k]));
      b += static_cast<double>(std::norm(bins[1][k]));
    }
  }
  return cross / std::sqrt(a * b);
}

TEST(DiffuseNoise, Coherence_of_two_microphones_is_the_sinc_of_their_distance) {
  for (const float distance : {0.032F, 0.064F, 0.2F}) {
    const auto noise = diffuse_noise(pair_of_mics(distance), NoiseColour::white, 5);
    for (const double hertz : {500.0, 1500.0, 2500.0, 4000.0, 6000.0}) {
      const double x = 2 * std::numbers::pi * hertz * static_cast<double>(distance) / 343;
      EXPECT_NEAR(coherence(noise, hertz), std::sin(x) / x, 0.06) << distance << " m, " << hertz << " Hz";
    }
  }
}

TEST(DiffuseNoise, A_cardioid_hears_a_third_of_its_power) {
  Scene scene = pair_of_mics(0.05F);
  scene.mics[1].omni = 0.5F;
  const auto noise = diffuse_noise(scene, NoiseColour::white, 5);
  double omni = 0, cardioid = 0;
  for (std::size_t n = 0; n < noise.cols(); ++n) {
    omni += static_cast<double>(noise[0][n]) * noise[0][n];
    cardioid += static_cast<double>(noise[1][n]) * noise[1][n];
  }
  EXPECT_NEAR(omni / static_cast<double>(noise.cols()), 1, 0.05);
  EXPECT_NEAR(cardioid / omni, 1.0 / 3, 0.02);
}

TEST(DiffuseNoise, Is_the_same_for_a_seed_and_another_for_another) {
  const Scene scene = pair_of_mics(0.1F);
  const auto a = diffuse_noise(scene, NoiseColour::pink, 5);
  const auto b = diffuse_noise(scene, NoiseColour::pink, 5);
  const auto c = diffuse_noise(scene, NoiseColour::pink, 6);
  EXPECT_TRUE(std::equal(a.data(), a.data() + 1000, b.data()));
  EXPECT_FALSE(std::equal(a.data(), a.data() + 1000, c.data()));
}

TEST(PointNoise, Has_rms_1_whatever_its_colour) {
  for (const auto colour : {NoiseColour::white, NoiseColour::pink, NoiseColour::fan}) {
    double power = 0;
    const auto noise = point_noise(colour, 65536, 16000, 3);
    for (const float x : noise) power += static_cast<double>(x) * x;
    EXPECT_NEAR(power / static_cast<double>(noise.size()), 1, 0.1);
  }
}

TEST(DiffuseNoise, Babble_has_the_colour_of_its_voices_and_comes_from_everywhere) {
  Scene scene = pair_of_mics(0.1F);
  scene.noise = DiffuseNoise{
      NoiseColour::babble,
      0,
      {point_noise(NoiseColour::pink, 40000, 16000, 1), point_noise(NoiseColour::pink, 40000, 16000, 2)}};
  const auto babble = diffuse_noise(scene, NoiseColour::babble, 5);
  for (const double hertz : {1000.0, 2500.0}) {
    const double x = 2 * std::numbers::pi * hertz * 0.1 / 343;
    EXPECT_NEAR(coherence(babble, hertz), std::sin(x) / x, 0.15) << hertz << " Hz";
  }
  double power = 0, difference = 0;
  for (std::size_t n = 1; n < babble.cols(); ++n) {
    power += std::pow(static_cast<double>(babble[0][n]), 2);
    difference += std::pow(static_cast<double>(babble[0][n] - babble[0][n - 1]), 2);
  }
  EXPECT_LT(difference, power);  // of white noise it would be twice the power
}

TEST(NoiseAmplitude, A_motor_has_the_harmonics_of_its_shaft) {
  for (const float harmonic : {110.F, 220.F, 1100.F}) {
    EXPECT_GT(noise_amplitude(NoiseColour::motor, harmonic),
              5 * noise_amplitude(NoiseColour::motor, harmonic + 55));
  }
}

TEST(NoiseAmplitude, Pink_falls_by_3_dB_an_octave_and_fan_by_6_over_its_corner) {
  const auto fall = [](NoiseColour colour) {
    return 20 * std::log10(noise_amplitude(colour, 2000) / noise_amplitude(colour, 4000));
  };
  EXPECT_NEAR(fall(NoiseColour::white), 0, 1e-4);
  EXPECT_NEAR(fall(NoiseColour::pink), 3.01, 0.01);
  EXPECT_NEAR(fall(NoiseColour::fan), 6.02, 0.05);
  EXPECT_LT(noise_amplitude(NoiseColour::fan, 15), noise_amplitude(NoiseColour::fan, 150));
}

}  // namespace
}  // namespace odas::noise_test
