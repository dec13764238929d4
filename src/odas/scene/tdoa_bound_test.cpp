// SPDX-License-Identifier: MIT
#include "odas/scene/tdoa_bound.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "odas/scene/noise.hpp"
#include "odas/scene/simulate.hpp"

namespace odas::tdoa_bound_test {
namespace {

Scene scene_of(float snr_db, float rt60 = 0) {
  Scene scene;
  scene.seconds = 4;
  scene.rt60 = rt60;
  scene.mics = {{{-0.03F, 0, 0}, {0, 0, 1}, 1}, {{0.03F, 0, 0}, {0, 0, 1}, 1}};
  SceneSource source;
  source.sound = point_noise(NoiseColour::white, 64000, 16000, 7);
  for (float& x : source.sound) x *= 0.05F;
  source.path = {{0, 40, 0, 1.5F}};
  scene.sources = {source};
  scene.noise = DiffuseNoise{NoiseColour::white, snr_db, {}};
  return scene;
}

double bound_of(const Scene& scene) {
  const auto bounds = tdoa_bounds(scene, played(scene, simulate(scene)));
  EXPECT_EQ(bounds.size(), 1U);
  return bounds.at(0);
}

// White signal and noise have one SNR at all frequencies, and the integral is (2 pi)^2 (7000^3 - 100^3) / 3.
TEST(TdoaBound, Of_white_sound_in_white_noise_is_the_closed_form) {
  for (const float snr_db : {0.F, 10.F}) {
    const double snr = std::pow(10.0, static_cast<double>(snr_db) / 10);
    const double coherence = std::pow(snr / (1 + snr), 2);
    const double band = 4 * 3.14159265 * 3.14159265 * (std::pow(7000.0, 3) - std::pow(100.0, 3)) / 3;
    const double expected = 1 / std::sqrt(2 * kBoundSeconds * band * coherence / (1 - coherence));
    EXPECT_NEAR(bound_of(scene_of(snr_db)) / expected, 1, 0.1) << snr_db << " dB";
  }
}

TEST(TdoaBound, Echoes_and_noise_make_it_worse) {
  const double quiet = bound_of(scene_of(20));
  EXPECT_GT(bound_of(scene_of(0)), 3 * quiet);
  EXPECT_GT(bound_of(scene_of(20, 0.4F)), 2 * quiet);
}

}  // namespace
}  // namespace odas::tdoa_bound_test
