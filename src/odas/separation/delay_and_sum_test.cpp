// SPDX-License-Identifier: MIT
#include "odas/separation/delay_and_sum.hpp"

#include <cmath>
#include <complex>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

namespace odas::delay_and_sum_test {
namespace {

using test::plane_wave;
using test::power;
using test::relative_distance;
using test::ring;
using test::track;

std::vector<cfloat> noise(std::size_t bins) { return test::Noise()(bins); }

TEST(DelayAndSum, gives_back_a_plane_wave_from_the_look_direction) {
  for (const std::size_t mics : {1U, 2U, 3U, 4U, 7U, 8U, 16U, 17U}) {
    const GeneralConfig general = ring(mics);
    const Vec3 u = direction_of(77, 20);
    const auto source = noise(129);
    DelayAndSum beamformer(general, 1);
    Grid<cfloat> beam(1, 129);
    const std::array tracks{track(1, u)};
    beamformer.separate(plane_wave(general, u, source), tracks, beam);
    EXPECT_LT(relative_distance(beam[0], source), 1e-5) << mics << " mics";
  }
}

TEST(DelayAndSum, gives_back_a_plane_wave_through_microphones_that_point_outwards) {
  GeneralConfig general = ring(8);
  for (MicConfig& mic : general.mics) {
    mic.direction = mic.mu;
    mic.angle = {60, 120};
  }
  const Vec3 u = direction_of(10, 0);
  const auto source = noise(129);
  // Each microphone hears it as loud as it points there.
  Grid<cfloat> spectra = plane_wave(general, u, source);
  std::array<float, 8> gains{};
  Steering(general).gains(u, gains);
  for (std::size_t m = 0; m < 8; ++m) {
    for (cfloat& x : spectra[m]) x *= gains[m];
  }
  DelayAndSum beamformer(general, 1);
  Grid<cfloat> beam(1, 129);
  const std::array tracks{track(1, u)};
  beamformer.separate(spectra, tracks, beam);
  EXPECT_LT(relative_distance(beam[0], source), 1e-5);
  // The microphone on the far side does not hear it, and has no part in it.
  EXPECT_EQ(power(beamformer.weights(0)[4]), 0);
  EXPECT_GT(power(beamformer.weights(0)[0]), 0);
}

TEST(DelayAndSum, attenuates_a_plane_wave_from_elsewhere) {
  const GeneralConfig general = ring(16, 0.15F);
  DelayAndSum beamformer(general, 1);
  Grid<cfloat> beam(1, 129);
  const std::array tracks{track(1, direction_of(0, 0))};
  const auto source = noise(129);
  beamformer.separate(plane_wave(general, direction_of(90, 0), source), tracks, beam);
  EXPECT_LT(power(beam[0]), 0.3 * power(source));
}

TEST(DelayAndSum, equals_the_formula_in_every_slot) {
  const GeneralConfig general = ring(5);
  DelayAndSum beamformer(general, 3);
  const Grid<cfloat> spectra = test::Noise()(5, 129);
  const std::array tracks{track(4, direction_of(10, 0)), track(0, direction_of(90, 0)),
                          track(9, direction_of(-120, 45))};
  Grid<cfloat> beams(3, 129);
  beams.fill({7, 7});
  beamformer.separate(spectra, tracks, beams);
  for (std::size_t s = 0; s < 3; ++s) {
    for (std::size_t k = 0; k < 129; ++k) {
      std::complex<double> expected = 0;
      for (std::size_t m = 0; m < 5 && tracks[s].id != 0; ++m) {
        const auto phase = test::phase_at(general, m, tracks[s].direction, k);
        expected += 0.2 * std::conj(phase) * std::complex<double>(spectra[m][k]);
      }
      EXPECT_LT(std::abs(std::complex<double>(beams[s][k]) - expected), 2e-5) << s << ' ' << k;
    }
  }
}

TEST(DelayAndSum, follows_a_direction_that_moves) {
  const GeneralConfig general = ring(8);
  DelayAndSum moved(general, 1);
  Grid<cfloat> beam(1, 129);
  const auto source = noise(129);
  for (const float azimuth : {0.F, 0.01F, 90.F, 90.F, -45.F}) {
    const Vec3 u = direction_of(azimuth, 10);
    const std::array tracks{track(1, u)};
    moved.separate(plane_wave(general, u, source), tracks, beam);
    EXPECT_LT(relative_distance(beam[0], source), 1e-5) << azimuth;
  }
}

// ODAS's fault B7: a track whose direction no microphone hears crashed it.
TEST(DelayAndSum, is_silent_towards_a_direction_that_no_microphone_hears) {
  GeneralConfig general = ring(4);
  for (MicConfig& mic : general.mics) mic.angle = {80, 90};
  DelayAndSum beamformer(general, 2);
  const auto source = noise(129);
  Grid<cfloat> spectra(4, 129);
  for (std::size_t m = 0; m < 4; ++m) std::copy(source.begin(), source.end(), spectra[m].begin());
  Grid<cfloat> beams(2, 129);
  beams.fill({7, 7});
  const std::array tracks{track(1, direction_of(0, -11)), track(2, direction_of(0, 80))};
  beamformer.separate(spectra, tracks, beams);
  EXPECT_EQ(power(beams[0]), 0);
  EXPECT_GT(power(beams[1]), 0);
  for (std::size_t m = 0; m < 4; ++m) EXPECT_EQ(power(beamformer.weights(0)[m]), 0);
}

TEST(DelayAndSum, weighs_nothing_in_a_slot_that_fell_empty) {
  const GeneralConfig general = ring(4);
  DelayAndSum beamformer(general, 1);
  Grid<cfloat> spectra(4, 129);
  Grid<cfloat> beams(1, 129);
  beamformer.separate(spectra, std::array{track(1, {1, 0, 0})}, beams);
  EXPECT_GT(power(beamformer.weights(0)[0]), 0);
  beamformer.separate(spectra, std::array{track(0, {1, 0, 0})}, beams);
  EXPECT_EQ(power(beamformer.weights(0)[0]), 0);
}

}  // namespace
}  // namespace odas::delay_and_sum_test
