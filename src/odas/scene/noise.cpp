// SPDX-License-Identifier: MIT
#include "odas/scene/noise.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include "odas/dsp/real_fft.hpp"
#include "odas/scene/random.hpp"

namespace odas {
namespace {

constexpr std::size_t kWaves = 192;

std::vector<float> amplitudes(NoiseColour colour, std::size_t size, int sample_rate) {
  std::vector<float> values(size / 2 + 1);
  double power = 0;
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    values[k] = noise_amplitude(
        colour, static_cast<float>(k) * static_cast<float>(sample_rate) / static_cast<float>(size));
    power += static_cast<double>(values[k]) * static_cast<double>(values[k]);
  }
  // Each bin has 2 parts of variance 1 and counts twice; the inverse DFT divides by the size.
  const auto scale = static_cast<float>(static_cast<double>(size) / (2 * std::sqrt(std::max(power, 1e-30))));
  for (float& value : values) value *= scale;
  return values;
}

std::size_t transform_size(std::size_t samples) { return std::max<std::size_t>(64, std::bit_ceil(samples)); }

Vec3 spiral(std::size_t index) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  const double z = 1 - (2 * static_cast<double>(index) + 1) / kWaves;
  const double flat = std::sqrt(1 - z * z);
  const double around = golden * static_cast<double>(index);
  return {static_cast<float>(flat * std::cos(around)), static_cast<float>(flat * std::sin(around)),
          static_cast<float>(z)};
}

}  // namespace

float noise_amplitude(NoiseColour colour, float hertz) noexcept {
  switch (colour) {
    case NoiseColour::white:
      return 1;
    case NoiseColour::pink:
      return 1 / std::sqrt(std::max(hertz, 50.F));
    case NoiseColour::fan: {
      const float f = hertz / 150;
      return f / (1 + f * f);
    }
  }
  return 0;
}

std::vector<float> point_noise(NoiseColour colour, std::size_t samples, int sample_rate, std::uint32_t seed) {
  RealFft fft(transform_size(samples));
  const auto shape = amplitudes(colour, fft.size(), sample_rate);
  Random random(seed);
  for (std::size_t k = 0; k < shape.size(); ++k) {
    const float re = random.uniform();
    const float im = random.uniform();
    fft.bins()[k] = shape[k] * cfloat(re, im);
  }
  fft.inverse();
  return {fft.time().begin(), fft.time().begin() + static_cast<std::ptrdiff_t>(samples)};
}

Grid<float> diffuse_noise(const Scene& scene, NoiseColour colour, std::uint32_t seed) {
  RealFft fft(transform_size(scene.samples()));
  const auto shape = amplitudes(colour, fft.size(), scene.sample_rate);
  const std::size_t bins = shape.size();
  Grid<cfloat> spectra(scene.mics.size(), bins);
  std::vector<cfloat> wave(bins);
  const float each = 1 / std::sqrt(static_cast<float>(kWaves));
  for (std::size_t w = 0; w < kWaves; ++w) {
    Random random = Random::of(seed, static_cast<std::uint32_t>(w));
    for (cfloat& value : wave) {
      const float re = random.uniform();
      const float im = random.uniform();
      value = cfloat(re, im);
    }
    const Vec3 from = spiral(w);
    for (std::size_t m = 0; m < scene.mics.size(); ++m) {
      const SceneMic& mic = scene.mics[m];
      const double advance =
          static_cast<double>(dot(mic.position, from) / scene.speed_of_sound) * scene.sample_rate;
      const double step = 2 * std::numbers::pi * advance / static_cast<double>(fft.size());
      const float gain = each * (mic.omni + (1 - mic.omni) * dot(mic.axis, from));
      const auto out = spectra[m];
      // The phase is stepped over short stretches, each begun afresh, so that errors do not grow.
      constexpr std::size_t kStretch = 256;
      const cfloat turn(static_cast<float>(std::cos(step)), static_cast<float>(std::sin(step)));
      for (std::size_t begin = 0; begin < bins; begin += kStretch) {
        const double angle = step * static_cast<double>(begin);
        cfloat phase =
            gain * cfloat(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
        const std::size_t end = std::min(bins, begin + kStretch);
        for (std::size_t k = begin; k < end; ++k) {
          out[k] += wave[k] * phase;
          phase *= turn;
        }
      }
    }
  }
  Grid<float> noise(scene.mics.size(), scene.samples());
  for (std::size_t m = 0; m < noise.rows(); ++m) {
    for (std::size_t k = 0; k < bins; ++k) fft.bins()[k] = shape[k] * spectra[m][k];
    fft.inverse();
    std::copy_n(fft.time().begin(), noise.cols(), noise[m].begin());
  }
  return noise;
}

}  // namespace odas
