// SPDX-License-Identifier: MIT
#include "odas/separation/single_source_filter.hpp"

#include <cmath>
#include <complex>

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

#include "odas/separation/delay_and_sum.hpp"

namespace odas::single_source_filter_test {
namespace {

using test::Noise;
using test::plane_wave;
using test::power;
using test::relative_distance;
using test::ring;
using test::track;

/// A delay-and-sum beam and what the filter makes of it.
struct Filtered {
  Grid<cfloat> beams;
  Grid<cfloat> out;

  Filtered(const GeneralConfig& general, const Grid<cfloat>& spectra, std::span<const Track> tracks,
           const SingleSourceFilterConfig& config = {})
      : beams(tracks.size(), 129), out(tracks.size(), 129) {
    DelayAndSum beamformer(general, tracks.size());
    beamformer.separate(spectra, tracks, beams);
    SingleSourceFilter filter(config, general);
    filter.apply(spectra, {}, tracks, beamformer, beams, out);
  }
};

TEST(SingleSourceFilter, passes_a_plane_wave_from_the_look_direction) {
  const GeneralConfig general = ring(8);
  const auto source = Noise()(129);
  const Vec3 u = direction_of(40, 20);
  const Filtered filtered(general, plane_wave(general, u, source), std::array{track(1, u)});
  EXPECT_LT(relative_distance(filtered.out[0], source), 0.01);
}

TEST(SingleSourceFilter, stops_noise_that_the_microphones_do_not_share) {
  const GeneralConfig general = ring(8);
  const Filtered filtered(general, Noise()(8, 129), std::array{track(1, direction_of(40, 20))});
  EXPECT_LT(power(filtered.out[0]), 0.05 * power(filtered.beams[0]));
}

TEST(SingleSourceFilter, equals_the_formula) {
  const GeneralConfig general = ring(4);
  const SingleSourceFilterConfig config{0.1F, 0.6F, 5};
  Grid<cfloat> spectra = Noise()(4, 129);
  const std::array tracks{track(0, {}), track(2, direction_of(10, 10))};
  const Filtered filtered(general, spectra, tracks, config);
  EXPECT_EQ(power(filtered.out[0]), 0);
  for (std::size_t k = 0; k < 129; ++k) {
    double parts = 0;
    for (std::size_t m = 0; m < 4; ++m) parts += static_cast<double>(std::norm(spectra[m][k])) / 16;
    const double ratio = static_cast<double>(std::norm(filtered.beams[1][k])) / (4 * parts);
    const double gain = 0.1 + 0.9 / (1 + std::exp(-5 * (ratio - 0.6)));
    EXPECT_LT(std::abs(std::complex<double>(filtered.out[1][k]) -
                       gain * std::complex<double>(filtered.beams[1][k])),
              1e-5);
  }
}

// ODAS divides by all microphones: on a closed array its ratio stays far from 1, and all is stopped.
TEST(SingleSourceFilter, counts_only_microphones_that_hear_the_source) {
  GeneralConfig general = ring(8);
  for (MicConfig& mic : general.mics) {
    mic.direction = mic.mu;
    mic.angle = {80, 100};
  }
  const auto source = Noise()(129);
  const Vec3 u = direction_of(22, 0);
  const Filtered filtered(general, plane_wave(general, u, source), std::array{track(1, u)});
  EXPECT_LT(relative_distance(filtered.out[0], filtered.beams[0]), 0.01);
}

TEST(SingleSourceFilter, keeps_silence_silent) {
  const GeneralConfig general = ring(4);
  const Filtered filtered(general, Grid<cfloat>(4, 129), std::array{track(1, {1, 0, 0})});
  EXPECT_EQ(power(filtered.out[0]), 0);
}

}  // namespace
}  // namespace odas::single_source_filter_test
