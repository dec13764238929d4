// SPDX-License-Identifier: MIT
#include "odas/classification/pitch.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "odas/base/contract.hpp"
#include "odas/dsp/window.hpp"

namespace odas {
namespace {

/// bins() of a transform -> circular autocorrelation in time().
void autocorrelate(RealFft& fft) noexcept {
  for (cfloat& x : fft.bins()) x = std::norm(x);
  fft.inverse();
}

}  // namespace

PitchDetector::PitchDetector(std::size_t frame_size, std::size_t reach, float voicing)
    : reach_(reach), fft_(frame_size), window_(root_hann(frame_size)), least_(frame_size / 2 + 1) {
  // A periodic sound repeats itself under the window: its peak falls as the window's own autocorrelation.
  std::copy(window_.begin(), window_.end(), fft_.time().begin());
  fft_.forward();
  autocorrelate(fft_);
  for (std::size_t lag = 0; lag < least_.size(); ++lag) {
    least_[lag] = voicing * fft_.time()[lag] / fft_.time()[0];
  }
}

float PitchDetector::period(std::span<const float> frame) noexcept {
  ODAS_EXPECT(frame.size() == window_.size());
  const std::span<float> r = fft_.time();
  for (std::size_t n = 0; n < frame.size(); ++n) r[n] = frame[n] * window_[n];
  fft_.forward();
  autocorrelate(fft_);

  const std::size_t peak = highest_peak(r);
  if (peak == 0 || !(r[peak] >= least_[peak] * r[0])) return 0;
  const float left = r[peak - 1];
  const float right = r[peak + 1];
  return static_cast<float>(peak) + (left - right) / (2 * left - 4 * r[peak] + 2 * right);
}

std::size_t PitchDetector::highest_peak(std::span<const float> r) const noexcept {
  std::size_t highest = 0;
  float height = 0;
  for (std::size_t i = reach_; i + reach_ < r.size() / 2 + 1; ++i) {
    if (r[i] <= height) continue;
    bool is_peak = true;
    for (std::size_t n = 1; n <= reach_ && is_peak; ++n) is_peak = r[i] > r[i - n] && r[i] > r[i + n];
    if (!is_peak) continue;
    highest = i;
    height = r[i];
  }
  return highest;
}

}  // namespace odas
