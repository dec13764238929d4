// SPDX-License-Identifier: MIT
// What it brings to leave out the microphones that cannot hear a direction: delay and sum on a closed array.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

#include "odas/config/reader.hpp"
#include "odas/dsp/stft.hpp"
#include "odas/scene/noise.hpp"
#include "odas/scene/simulate.hpp"
#include "odas/separation/delay_and_sum.hpp"

namespace odas::sub_array_test {
namespace {

constexpr std::size_t kFrame = 512, kHop = 128;

/// Pink noise of a talker's place, 1.5 m away, and pink noise from everywhere, as cardioids around a body
/// hear them.
Scene scene_of(const GeneralConfig& array, float azimuth, float rt60) {
  Scene scene;
  scene.seconds = 3;
  scene.rt60 = rt60;
  for (const MicConfig& mic : array.mics) {
    SceneMic made;
    made.position = {mic.mu[0], mic.mu[1], mic.mu[2]};
    made.axis = {mic.direction[0], mic.direction[1], mic.direction[2]};
    made.omni = 0.5F;
    scene.mics.push_back(made);
  }
  SceneSource talker;
  talker.sound = point_noise(NoiseColour::pink, scene.samples(), scene.sample_rate, 1);
  talker.path = {{0, azimuth, 10, 1.5F}};
  scene.sources.push_back(talker);
  scene.noise = DiffuseNoise{NoiseColour::pink, 0, {}};
  return scene;
}

double power_of_beam(const GeneralConfig& array, Vec3 direction, GridView<const float> sound) {
  DelayAndSum beamformer(array, 1);
  Stft stft(sound.rows(), kHop, kFrame);
  Grid<float> hop(sound.rows(), kHop);
  Grid<cfloat> spectra(sound.rows(), stft.bins()), beams(1, stft.bins());
  const std::vector<Track> tracks{test::track(1, direction)};
  double power = 0;
  for (std::size_t start = 8000; start + kHop <= sound.cols(); start += kHop) {
    for (std::size_t m = 0; m < sound.rows(); ++m) {
      std::copy_n(sound[m].data() + start, kHop, hop[m].data());
    }
    stft.analyse(hop, spectra);
    beamformer.separate(spectra, tracks, beams);
    for (const cfloat y : beams[0]) power += static_cast<double>(std::norm(y));
  }
  return power;
}

/// Of delay and sum, dB.
double snr(const GeneralConfig& array, const Scene& scene, const SimulatedScene& sound) {
  Grid<float> noise = sound.mics;
  for (std::size_t m = 0; m < noise.rows(); ++m) {
    for (std::size_t n = 0; n < noise.cols(); ++n) noise[m][n] -= sound.images_at_all[0][m][n];
  }
  const Vec3 direction = sound.truth[0].direction[scene.hops() / 2];
  return 10 * std::log10(power_of_beam(array, direction, sound.images_at_all[0]) /
                         power_of_beam(array, direction, noise));
}

TEST(SubArray, of_the_microphones_that_hear_a_direction_is_a_decibel_better_than_all_of_a_closed_array) {
  const auto file = std::filesystem::path(ODAS_SOURCE_DIR) / "configs" / "azimut3_closed_16.cfg";
  GeneralConfig some = load_configuration(file).config.pipeline.general;
  some.size.frame_size = kFrame;
  GeneralConfig all = some;
  for (MicConfig& mic : all.mics) mic.angle = {180, 180};
  double gain = 0, cases = 0;
  for (const float rt60 : {0.F, 0.3F}) {
    for (const float azimuth : {0.F, 30.F, 45.F}) {
      const Scene scene = scene_of(some, azimuth, rt60);
      const SimulatedScene sound = simulate(scene, {}, Images::of_all);
      const double of_some = snr(some, scene, sound), of_all = snr(all, scene, sound);
      std::printf("rt60 %.1f s, azimuth %2.0f deg: SNR of all %.2f dB, of those that hear it %.2f dB\n",
                  static_cast<double>(rt60), static_cast<double>(azimuth), of_all, of_some);
      gain += of_some - of_all;
      cases += 1;
    }
  }
  std::printf("mean gain: %.2f dB\n", gain / cases);
  EXPECT_GE(gain / cases, 1);
}

}  // namespace
}  // namespace odas::sub_array_test
