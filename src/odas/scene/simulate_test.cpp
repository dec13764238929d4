// SPDX-License-Identifier: MIT
#include "odas/scene/simulate.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "odas/scene/random.hpp"
#include "odas/scene/trajectory.hpp"

namespace odas::simulate_test {
namespace {

std::vector<float> sine(double hertz, double seconds, double rate = 16000) {
  std::vector<float> sound(static_cast<std::size_t>(seconds * rate));
  for (std::size_t n = 0; n < sound.size(); ++n) {
    sound[n] =
        static_cast<float>(0.1 * std::sin(2 * std::numbers::pi * hertz * static_cast<double>(n) / rate));
  }
  return sound;
}

Scene small_scene(float rt60) {
  Scene scene;
  scene.seconds = 2;
  scene.rt60 = rt60;
  scene.mics = {{{-0.032F, 0, 0}, {0, 0, 1}, 1}, {{0.032F, 0, 0}, {0, 0, 1}, 1}};
  SceneSource source;
  source.name = "walker";
  source.sound = sine(700, 2);
  source.path = {{0, -60, 10, 1.2F}, {2, 60, 10, 1.4F}};
  scene.sources = {source};
  return scene;
}

double power(std::span<const float> x) {
  double sum = 0;
  for (const float v : x) sum += static_cast<double>(v) * v;
  return sum / static_cast<double>(x.size());
}

TEST(Simulate, Same_scene_same_samples) {
  Scene scene = small_scene(0.15F);
  scene.noise = DiffuseNoise{NoiseColour::white, 10, {}};
  const SimulatedScene a = simulate(scene);
  const SimulatedScene b = simulate(scene);
  EXPECT_TRUE(std::equal(a.mics.data(), a.mics.data() + 2 * a.mics.cols(), b.mics.data()));
  scene.seed = 2;
  const SimulatedScene c = simulate(scene);
  EXPECT_FALSE(std::equal(a.mics.data(), a.mics.data() + 2 * a.mics.cols(), c.mics.data()));
}

// A click is a jump from one sample to the next; a sine has a known steepest slope, and its waves of all
// walls cannot jump either. A second difference shows clicks that the slope of the tone would hide.
TEST(Simulate, A_talker_that_moves_makes_no_clicks) {
  for (const float rt60 : {0.F, 0.25F}) {
    const Scene scene = small_scene(rt60);
    const auto result = simulate(scene);
    const auto x = result.mics[0];
    const double omega = 2 * std::numbers::pi * 700 / 16000;
    double peak = 0;
    double bend = 0;
    for (std::size_t n = 2000; n + 1 < x.size() - 200; ++n) {
      peak = std::max(peak, std::abs(static_cast<double>(x[n])));
      bend = std::max(bend, std::abs(static_cast<double>(x[n + 1] - 2 * x[n] + x[n - 1])));
    }
    EXPECT_LT(bend, 1.1 * omega * omega * peak) << "rt60 " << rt60;
  }
}

TEST(Simulate, A_talker_that_moves_sounds_at_each_place_as_one_that_rests_there) {
  Scene moving = small_scene(0);
  moving.sources[0].path = {{0, -5, 0, 1.5F}, {2, 5, 0, 1.5F}};
  Scene resting = moving;
  resting.sources[0].path = {{0, 0, 0, 1.5F}};
  const auto a = simulate(moving);
  const auto b = simulate(resting);
  // In the middle, where both are at the same place, for 4 ms.
  const auto middle = a.mics.cols() / 2 + 70;
  for (std::size_t n = middle - 32; n < middle + 32; ++n) EXPECT_NEAR(a.mics[1][n], b.mics[1][n], 2e-4);
}

TEST(Simulate, Truth_follows_the_waypoints) {
  const Scene scene = small_scene(0);
  const auto result = simulate(scene);
  ASSERT_EQ(result.truth.size(), 1U);
  ASSERT_EQ(result.truth[0].direction.size(), scene.hops());
  for (std::size_t h = 1; h < scene.hops(); ++h) {
    // 60 degrees a second; the sound is some 4 ms old.
    const double time = (static_cast<double>(h) + 0.5) * 0.008 - 1.3 / 343;
    EXPECT_NEAR(azimuth_deg(result.truth[0].direction[h]), -60 + 60 * time, 0.05);
    EXPECT_NEAR(elevation_deg(result.truth[0].direction[h]), 10, 1e-3);
    EXPECT_TRUE(result.truth[0].active[h]);
  }
}

TEST(Simulate, Noise_is_as_far_under_the_talkers_as_asked) {
  Scene scene = small_scene(0.2F);
  const auto clean = simulate(scene);
  scene.noise = DiffuseNoise{NoiseColour::pink, 12, {}};
  const auto noisy = simulate(scene);
  Grid<float> noise(2, clean.mics.cols());
  double speech_power = 0;
  double noise_power = 0;
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t n = 0; n < noise.cols(); ++n) noise[m][n] = noisy.mics[m][n] - clean.mics[m][n];
    speech_power += power(clean.mics[m]);
    noise_power += power(noise[m]);
  }
  EXPECT_NEAR(10 * std::log10(speech_power / noise_power), 12, 0.2);
}

TEST(Simulate, Images_sum_to_what_the_first_microphone_hears) {
  Scene scene = small_scene(0.15F);
  SceneSource second = scene.sources[0];
  second.path = {{0, 170, 0, 1}};
  second.sound = sine(1100, 1);
  scene.sources.push_back(second);
  const auto result = simulate(scene);
  ASSERT_EQ(result.images.size(), 2U);
  for (std::size_t n = 0; n < scene.samples(); ++n) {
    EXPECT_NEAR(result.images[0][n] + result.images[1][n], result.mics[0][n], 1e-6);
  }
}

TEST(Simulate, Directional_noise_is_heard_and_is_not_in_the_truth) {
  Scene scene = small_scene(0);
  scene.sources[0].is_target = false;
  const auto result = simulate(scene);
  EXPECT_TRUE(result.truth.empty());
  EXPECT_TRUE(result.images.empty());
  EXPECT_GT(power(result.mics[0]), 1e-4);
}

TEST(Simulate, What_is_too_loud_is_scaled_and_not_clipped) {
  Scene scene = small_scene(0);
  for (float& x : scene.sources[0].sound) x *= 50;
  const auto result = simulate(scene);
  float peak = 0;
  for (std::size_t m = 0; m < 2; ++m) {
    for (const float x : result.mics[m]) peak = std::max(peak, std::abs(x));
  }
  EXPECT_NEAR(peak, 0.95, 1e-4);
  EXPECT_LT(result.scale, 1);
  EXPECT_NEAR(result.images[0][20000], result.mics[0][20000], 1e-6);
}

}  // namespace
}  // namespace odas::simulate_test
