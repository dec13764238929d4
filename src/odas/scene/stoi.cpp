// SPDX-License-Identifier: MIT
#include "odas/scene/stoi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <samplerate.h>

#include "odas/base/contract.hpp"
#include "odas/base/grid.hpp"
#include "odas/dsp/real_fft.hpp"

namespace odas {
namespace {

constexpr int kRate = 10000;  // Hz
constexpr std::size_t kFrame = 256, kHop = 128, kFft = 512;
constexpr std::size_t kBands = 15, kStretch = 30;
constexpr double kLowestCentre = 150;  // Hz
constexpr double kSilence = 40;        // dB
constexpr double kClip = 15;           // dB
constexpr double kTinyBand = 1e-12;

std::vector<float> resampled(std::span<const float> sound, int sample_rate) {
  std::vector<float> in(sound.begin(), sound.end());
  if (sample_rate == kRate || in.empty()) return in;
  const double ratio = static_cast<double>(kRate) / sample_rate;
  std::vector<float> out(static_cast<std::size_t>(static_cast<double>(in.size()) * ratio) + 1);
  SRC_DATA data{};
  data.data_in = in.data();
  data.data_out = out.data();
  data.input_frames = static_cast<long>(in.size());
  data.output_frames = static_cast<long>(out.size());
  data.src_ratio = ratio;
  const int error = src_simple(&data, SRC_SINC_MEDIUM_QUALITY, 1);
  ODAS_EXPECT(error == 0);
  out.resize(static_cast<std::size_t>(data.output_frames_gen));
  return out;
}

std::array<float, kFrame> window() {
  std::array<float, kFrame> hann{};
  for (std::size_t n = 0; n < kFrame; ++n) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(n + 1) / (kFrame + 1);
    hann[n] = static_cast<float>(0.5 - 0.5 * std::cos(angle));
  }
  return hann;
}

/// Where the frames begin in which the clean speech is loud enough.
std::vector<std::size_t> frames_of_speech(std::span<const float> clean) {
  const auto hann = window();
  std::vector<double> level;
  for (std::size_t start = 0; start + kFrame <= clean.size(); start += kHop) {
    double energy = kTinyBand;
    for (std::size_t n = 0; n < kFrame; ++n)
      energy += std::pow(static_cast<double>(hann[n] * clean[start + n]), 2);
    level.push_back(10 * std::log10(energy));
  }
  std::vector<std::size_t> starts;
  if (level.empty()) return starts;
  const double loudest = *std::ranges::max_element(level);
  for (std::size_t i = 0; i < level.size(); ++i) {
    if (level[i] > loudest - kSilence) starts.push_back(i * kHop);
  }
  return starts;
}

/// The frames, put together again without those that are left out.
std::vector<float> joined(std::span<const float> sound, const std::vector<std::size_t>& starts) {
  const auto hann = window();
  std::vector<float> out((starts.size() - 1) * kHop + kFrame);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    for (std::size_t n = 0; n < kFrame; ++n) out[i * kHop + n] += hann[n] * sound[starts[i] + n];
  }
  return out;
}

/// [band][frame]: amplitudes of the one-third octave bands.
Grid<double> bands_of(std::span<const float> sound) {
  const auto hann = window();
  const std::size_t frames = sound.size() < kFrame ? 0 : (sound.size() - kFrame) / kHop + 1;
  Grid<double> bands(kBands, frames);
  RealFft fft(kFft);
  const double step = static_cast<double>(kRate) / kFft;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    std::ranges::fill(fft.time(), 0.F);
    for (std::size_t n = 0; n < kFrame; ++n) fft.time()[n] = hann[n] * sound[frame * kHop + n];
    fft.forward();
    for (std::size_t b = 0; b < kBands; ++b) {
      const double centre = kLowestCentre * std::pow(2, static_cast<double>(b) / 3);
      const auto low = static_cast<std::size_t>(std::lround(centre * std::pow(2, -1.0 / 6) / step));
      const auto high = static_cast<std::size_t>(std::lround(centre * std::pow(2, 1.0 / 6) / step));
      double power = 0;
      for (std::size_t k = low; k < high; ++k) power += static_cast<double>(std::norm(fft.bins()[k]));
      bands[b][frame] = std::sqrt(power);
    }
  }
  return bands;
}

/// Of one stretch of one band.
double correlation(std::span<const double> clean, std::span<const double> processed) {
  double clean_energy = 0, energy = 0;
  for (std::size_t i = 0; i < kStretch; ++i) {
    clean_energy += clean[i] * clean[i];
    energy += processed[i] * processed[i];
  }
  const double gain = std::sqrt(clean_energy / std::max(energy, kTinyBand));
  const double most = 1 + std::pow(10, kClip / 20);
  std::array<double, kStretch> fitted{};
  double mean_clean = 0, mean_fitted = 0;
  for (std::size_t i = 0; i < kStretch; ++i) {
    fitted[i] = std::min(gain * processed[i], most * clean[i]);
    mean_clean += clean[i] / kStretch;
    mean_fitted += fitted[i] / kStretch;
  }
  double cross = 0, a = kTinyBand, b = kTinyBand;
  for (std::size_t i = 0; i < kStretch; ++i) {
    const double x = clean[i] - mean_clean, y = fitted[i] - mean_fitted;
    cross += x * y;
    a += x * x;
    b += y * y;
  }
  return cross / std::sqrt(a * b);
}

}  // namespace

std::optional<double> stoi(std::span<const float> clean, std::span<const float> processed, int sample_rate) {
  ODAS_EXPECT(clean.size() == processed.size());
  const auto x = resampled(clean, sample_rate);
  const auto y = resampled(processed, sample_rate);
  const auto starts = frames_of_speech(x);
  if (starts.size() < kStretch) return std::nullopt;
  const Grid<double> clean_bands = bands_of(joined(x, starts));
  const Grid<double> bands = bands_of(joined(y, starts));
  double sum = 0, count = 0;
  for (std::size_t end = kStretch; end <= clean_bands.cols(); ++end) {
    for (std::size_t b = 0; b < kBands; ++b) {
      sum += correlation(clean_bands[b].subspan(end - kStretch, kStretch),
                         bands[b].subspan(end - kStretch, kStretch));
      count += 1;
    }
  }
  return sum / count;
}

}  // namespace odas
