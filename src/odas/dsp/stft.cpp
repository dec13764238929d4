// SPDX-License-Identifier: MIT
#include "odas/dsp/stft.hpp"

#include <algorithm>

#include "odas/dsp/window.hpp"

namespace odas {

Stft::Stft(std::size_t channels, std::size_t hop_size, std::size_t frame_size)
    : hop_size_(hop_size), window_(root_hann(frame_size)), frames_(channels, frame_size), fft_(frame_size) {
  ODAS_EXPECT(hop_size >= 1 && hop_size <= frame_size);
}

void Stft::analyse(GridView<const float> hops, GridView<cfloat> spectra) noexcept {
  ODAS_EXPECT(hops.rows() == frames_.rows() && hops.cols() == hop_size_);
  ODAS_EXPECT(spectra.rows() == frames_.rows() && spectra.cols() == bins());
  for (std::size_t c = 0; c < frames_.rows(); ++c) {
    const std::span<float> frame = frames_[c];
    std::copy(frame.begin() + static_cast<std::ptrdiff_t>(hop_size_), frame.end(), frame.begin());
    std::copy(hops[c].begin(), hops[c].end(), frame.end() - static_cast<std::ptrdiff_t>(hop_size_));
    const std::span<float> time = fft_.time();
    for (std::size_t n = 0; n < frame.size(); ++n) time[n] = frame[n] * window_[n];
    fft_.forward();
    std::copy(fft_.bins().begin(), fft_.bins().end(), spectra[c].begin());
  }
}

void Stft::reset() noexcept { frames_.fill(0); }

Istft::Istft(std::size_t channels, std::size_t hop_size, std::size_t frame_size)
    : hop_size_(hop_size),
      window_(synthesis_window(root_hann(frame_size), hop_size)),
      sums_(channels, frame_size),
      silent_for_(channels, frame_size),
      fft_(frame_size) {
  ODAS_EXPECT(hop_size >= 1 && hop_size <= frame_size);
}

void Istft::synthesise(GridView<const cfloat> spectra, GridView<float> hops) noexcept {
  ODAS_EXPECT(spectra.rows() == sums_.rows() && spectra.cols() == fft_.bins().size());
  ODAS_EXPECT(hops.rows() == sums_.rows() && hops.cols() == hop_size_);
  for (std::size_t c = 0; c < sums_.rows(); ++c) {
    const std::span<float> sum = sums_[c];
    const auto hop = static_cast<std::ptrdiff_t>(hop_size_);
    // An empty slot costs nothing: its spectrum is zero, and once its last frame has rung out, so is its sum.
    const bool silent =
        std::all_of(spectra[c].begin(), spectra[c].end(), [](cfloat x) { return x == cfloat{}; });
    silent_for_[c] = silent ? std::min(silent_for_[c] + 1, sum.size()) : 0;
    if (silent_for_[c] * hop_size_ > sum.size()) {
      std::fill(hops[c].begin(), hops[c].end(), 0.F);
      continue;
    }
    std::copy(sum.begin() + hop, sum.end(), sum.begin());
    std::fill(sum.end() - hop, sum.end(), 0.F);
    if (!silent) {
      std::copy(spectra[c].begin(), spectra[c].end(), fft_.bins().begin());
      fft_.inverse();
      const std::span<const float> time = fft_.time();
      for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += time[n] * window_[n];
    }
    std::copy(sum.begin(), sum.begin() + hop, hops[c].begin());
  }
}

void Istft::reset(std::size_t channel) noexcept {
  std::fill(sums_[channel].begin(), sums_[channel].end(), 0.F);
  silent_for_[channel] = sums_.cols();
}

void Istft::reset() noexcept {
  for (std::size_t c = 0; c < sums_.rows(); ++c) reset(c);
}

}  // namespace odas
