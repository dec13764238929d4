// SPDX-License-Identifier: MIT
// What microphones hear, for tests of what works on spectra: arrays, plane waves, noise.
#pragma once

#include <complex>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/types.hpp"

namespace odas::test {

/// `mics` microphones on a circle in the xy plane, that hear all around.
inline GeneralConfig ring(std::size_t mics, float radius = 0.1F) {
  GeneralConfig general;
  general.spatialfilters.emplace();
  for (std::size_t m = 0; m < mics; ++m) {
    const Vec3 p = radius * direction_of(360.F * static_cast<float>(m) / static_cast<float>(mics), 0);
    MicConfig mic;
    mic.mu = {p.x, p.y, p.z};
    general.mics.push_back(mic);
  }
  return general;
}

inline Track track(std::uint64_t id, Vec3 direction) {
  Track out;
  out.id = id;
  out.direction = direction;
  out.activity = id == 0 ? 0.F : 1.F;
  return out;
}

/// White noise, the real and the imaginary part of each bin with a standard deviation of 1.
class Noise {
 public:
  explicit Noise(unsigned seed = 1) : random_(seed) {}

  std::vector<cfloat> operator()(std::size_t bins) {
    std::vector<cfloat> out(bins);
    for (cfloat& x : out) x = {normal_(random_), normal_(random_)};
    return out;
  }
  /// Each row by itself.
  Grid<cfloat> operator()(std::size_t rows, std::size_t bins) {
    Grid<cfloat> out(rows, bins);
    for (std::size_t r = 0; r < rows; ++r) {
      for (cfloat& x : out[r]) x = {normal_(random_), normal_(random_)};
    }
    return out;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<float> normal_;
};

/// The phase at a microphone of a plane wave from `u`, against the origin: by the definition.
inline std::complex<double> phase_at(const GeneralConfig& g, std::size_t mic, Vec3 u, std::size_t bin) {
  const auto& p = g.mics[mic].mu;
  const double path = double{p[0]} * double{u.x} + double{p[1]} * double{u.y} + double{p[2]} * double{u.z};
  const double hertz = static_cast<double>(bin) * g.samplerate.mu / g.size.frame_size;
  return std::polar(1.0, 2 * M_PI * hertz * path / static_cast<double>(g.speedofsound.mu));
}

/// Adds to spectra [mic][bin] a plane wave from `u` whose spectrum at the origin is `source`.
inline void add_plane_wave(const GeneralConfig& general, Vec3 u, std::span<const cfloat> source,
                           Grid<cfloat>& spectra) {
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    for (std::size_t k = 0; k < source.size(); ++k) {
      spectra[m][k] += cfloat(phase_at(general, m, u, k)) * source[k];
    }
  }
}

inline Grid<cfloat> plane_wave(const GeneralConfig& general, Vec3 u, std::span<const cfloat> source) {
  Grid<cfloat> spectra(general.mics.size(), source.size());
  add_plane_wave(general, u, source, spectra);
  return spectra;
}

inline double power(std::span<const cfloat> x) {
  double sum = 0;
  for (const cfloat v : x) sum += static_cast<double>(std::norm(v));
  return sum;
}

/// Root of the power of a - b over that of b.
inline double relative_distance(std::span<const cfloat> a, std::span<const cfloat> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += static_cast<double>(std::norm(a[k] - b[k]));
  return std::sqrt(sum / power(b));
}

}  // namespace odas::test
