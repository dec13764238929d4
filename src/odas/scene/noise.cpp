// SPDX-License-Identifier: MIT
#include "odas/scene/noise.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include "odas/base/contract.hpp"
#include "odas/dsp/real_fft.hpp"
#include "odas/scene/random.hpp"

namespace odas {
namespace {

constexpr std::size_t kWaves = 192;
constexpr std::size_t kCrowd = 24;
constexpr double kHall = 0.05;  // s between the arrivals of one voice of a crowd

using Wave = std::vector<cfloat>;

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

float motor_amplitude(float hertz) noexcept {
  constexpr float kShaft = 110;  // Hz
  constexpr float kWidth = 3;    // Hz: no shaft turns quite evenly
  const float off = hertz - kShaft * std::max(1.F, std::round(hertz / kShaft));
  const float fall = 1 / (1 + hertz / 800);
  return fall * (0.08F + std::exp(-off * off / (2 * kWidth * kWidth)));
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
    case NoiseColour::motor:
      return motor_amplitude(hertz);
    case NoiseColour::babble:
      return 1;
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

namespace {

Wave random_wave(std::size_t bins, std::uint32_t seed, std::size_t index) {
  Random random = Random::of(seed, static_cast<std::uint32_t>(index));
  Wave wave(bins);
  for (cfloat& value : wave) {
    const float re = random.uniform();
    const float im = random.uniform();
    value = cfloat(re, im);
  }
  return wave;
}

/// wave[k] *= gain e^(j step k), stepped over short stretches, each begun afresh, so that errors do not grow.
template <class Visit>
void for_each_phase(std::size_t bins, double step, float gain, Visit&& visit) {
  constexpr std::size_t kStretch = 256;
  std::array<cfloat, kStretch> turns;
  for (std::size_t k = 0; k < kStretch; ++k) {
    turns[k] = cfloat(std::polar(1.0, step * static_cast<double>(k)));
  }
  for (std::size_t begin = 0; begin < bins; begin += kStretch) {
    const cfloat base(std::polar(static_cast<double>(gain), step * static_cast<double>(begin)));
    visit(begin, std::min(bins, begin + kStretch), base, turns);
  }
}

/// The spectra of the voices, each repeated until it fills the transform.
std::vector<Wave> crowd_of(const std::vector<std::vector<float>>& voices, RealFft& fft) {
  std::vector<Wave> spectra;
  for (const auto& voice : voices) {
    ODAS_EXPECT(!voice.empty());
    for (std::size_t n = 0; n < fft.size(); ++n) fft.time()[n] = voice[n % voice.size()];
    fft.forward();
    spectra.emplace_back(fft.bins().begin(), fft.bins().end());
  }
  return spectra;
}

/// A voice of the crowd, from its own moment on, as it comes from the direction `index`.
Wave crowd_wave(const std::vector<Wave>& voices, int sample_rate, std::size_t size, std::uint32_t seed,
                std::size_t index) {
  const std::size_t talker = index % kCrowd;
  Random of_talker = Random::of(seed, static_cast<std::uint32_t>(talker));
  Random of_wave = Random::of(seed, static_cast<std::uint32_t>(kWaves + index));
  const auto share = [](Random& random) { return 0.5 + static_cast<double>(random.uniform()) / 3.4642; };
  const double moment = std::floor(share(of_talker) * static_cast<double>(size));
  const double delay = moment + share(of_wave) * kHall * sample_rate;
  Wave wave = voices[talker % voices.size()];
  for_each_phase(wave.size(), -2 * std::numbers::pi * delay / static_cast<double>(size), 1,
                 [&](std::size_t begin, std::size_t end, cfloat base, const auto& turns) {
                   for (std::size_t k = begin; k < end; ++k) wave[k] *= base * turns[k - begin];
                 });
  return wave;
}

}  // namespace

Grid<float> diffuse_noise(const Scene& scene, NoiseColour colour, std::uint32_t seed) {
  RealFft fft(transform_size(scene.samples()));
  const auto shape = amplitudes(colour, fft.size(), scene.sample_rate);
  const std::size_t bins = shape.size();
  Grid<cfloat> spectra(scene.mics.size(), bins);
  const bool babble = colour == NoiseColour::babble;
  ODAS_EXPECT(!babble || (scene.noise && !scene.noise->voices.empty()));
  const std::vector<Wave> voices = babble ? crowd_of(scene.noise->voices, fft) : std::vector<Wave>();
  const float each = 1 / std::sqrt(static_cast<float>(kWaves));
  for (std::size_t w = 0; w < kWaves; ++w) {
    const Wave wave =
        babble ? crowd_wave(voices, scene.sample_rate, fft.size(), seed, w) : random_wave(bins, seed, w);
    const Vec3 from = spiral(w);
    for (std::size_t m = 0; m < scene.mics.size(); ++m) {
      const SceneMic& mic = scene.mics[m];
      const double advance =
          static_cast<double>(dot(mic.position, from) / scene.speed_of_sound) * scene.sample_rate;
      const double step = 2 * std::numbers::pi * advance / static_cast<double>(fft.size());
      const auto out = spectra[m];
      for_each_phase(bins, step, each * (mic.omni + (1 - mic.omni) * dot(mic.axis, from)),
                     [&](std::size_t begin, std::size_t end, cfloat base, const auto& turns) {
                       for (std::size_t k = begin; k < end; ++k)
                         out[k] += wave[k] * (base * turns[k - begin]);
                     });
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
