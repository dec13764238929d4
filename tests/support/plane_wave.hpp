// SPDX-License-Identifier: MIT
// Arrays, and what they hear of a plane wave.
#pragma once

#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/types.hpp"

namespace odas::test {

inline MicConfig mic_at(Vec3 p, Vec3 direction = {0, 0, 1}, std::array<float, 2> angle = {180, 180}) {
  return {{p.x, p.y, p.z}, {}, {direction.x, direction.y, direction.z}, angle};
}

/// Microphones on a circle in the xy plane, facing up; hears everything.
inline GeneralConfig ring(std::size_t mics, float radius) {
  GeneralConfig config;
  for (std::size_t m = 0; m < mics; ++m) {
    const float a = 360 * static_cast<float>(m) / static_cast<float>(mics);
    config.mics.push_back(mic_at(radius * direction_of(a, 0)));
  }
  config.spatialfilters.emplace();
  return config;
}

/// Corners of a tetrahedron: an array with depth.
inline GeneralConfig tetrahedron(float side) {
  GeneralConfig config;
  const float s = side / std::sqrt(8.F);
  for (const Vec3 p : {Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1}, Vec3{-1, -1, 1}}) {
    config.mics.push_back(mic_at(s * p));
  }
  config.spatialfilters.emplace();
  return config;
}

/// White spectra [mic][bin] of independent noise.
inline Grid<cfloat> noise_spectra(const GeneralConfig& config, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  Grid<cfloat> spectra(config.mics.size(), static_cast<std::size_t>(config.size.frame_size) / 2 + 1);
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    for (cfloat& x : spectra[m]) x = {normal(random), normal(random)};
  }
  return spectra;
}

/// Spectra [mic][bin] of a white plane wave from `u`.
inline Grid<cfloat> plane_wave(const GeneralConfig& config, Vec3 u, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  const auto frame = static_cast<double>(config.size.frame_size);
  Grid<cfloat> spectra(config.mics.size(), static_cast<std::size_t>(config.size.frame_size) / 2 + 1);
  for (std::size_t k = 0; k < spectra.cols(); ++k) {
    const std::complex<double> source(normal(random), normal(random));
    const double omega = 2 * std::numbers::pi * static_cast<double>(k) / frame * config.samplerate.mu;
    for (std::size_t m = 0; m < spectra.rows(); ++m) {
      const auto& p = config.mics[m].mu;
      const double ahead = static_cast<double>(dot({p[0], p[1], p[2]}, u) / config.speedofsound.mu);
      spectra[m][k] = cfloat(source * std::polar(1.0, omega * ahead));
    }
  }
  return spectra;
}

inline float angle_deg(Vec3 a, Vec3 b) {
  return degrees(std::acos(std::clamp(dot(normalized(a), normalized(b)), -1.F, 1.F)));
}

}  // namespace odas::test
