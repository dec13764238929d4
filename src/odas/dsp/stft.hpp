// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/dsp/real_fft.hpp"

namespace odas {

/// Short-time Fourier transform of several channels, hop by hop.
/// Method: the last N samples times a symmetric root-Hann window (ODAS's), unscaled DFT.
/// Shapes: hops [channel][hop] -> spectra [channel][bin], bin = N/2 + 1. Starts from silence.
class Stft {
 public:
  Stft(std::size_t channels, std::size_t hop_size, std::size_t frame_size);

  void analyse(GridView<const float> hops, GridView<cfloat> spectra) noexcept;
  void reset() noexcept;

  [[nodiscard]] std::size_t bins() const noexcept { return fft_.size() / 2 + 1; }

 private:
  std::size_t hop_size_;
  std::vector<float> window_;
  Grid<float> frames_;  // [channel][N]: the last N samples
  RealFft fft_;
};

/// Inverse of Stft: overlap-add with the synthesis window that gives a gain of exactly 1.
/// Delay: N - hop samples against the hops that went into Stft.
class Istft {
 public:
  Istft(std::size_t channels, std::size_t hop_size, std::size_t frame_size);

  /// spectra [channel][bin] -> hops [channel][hop].
  void synthesise(GridView<const cfloat> spectra, GridView<float> hops) noexcept;
  /// Forgets what one channel still had to say.
  void reset(std::size_t channel) noexcept;
  void reset() noexcept;

 private:
  std::size_t hop_size_;
  std::vector<float> window_;
  Grid<float> sums_;                     // [channel][N]: the overlap-add
  std::vector<std::size_t> silent_for_;  // [channel]: hops in a row with nothing to add
  RealFft fft_;
};

}  // namespace odas
