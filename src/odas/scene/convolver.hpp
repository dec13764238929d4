// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/base/grid.hpp"
#include "odas/dsp/real_fft.hpp"

namespace odas {

/// One sound through one response a microphone, a piece at a time, by FFT.
class Convolver {
 public:
  /// Pieces of up to `piece` samples, responses of up to `response` samples.
  Convolver(std::size_t mics, std::size_t piece, std::size_t response);

  /// `responses`: [mic][sample].
  void set_responses(GridView<const float> responses) noexcept;

  /// out[mic][start + n] += (piece * response[mic])[n]. What lies behind the end of `out` is lost.
  void add(std::span<const float> piece, std::size_t start, GridView<float> out) noexcept;

 private:
  RealFft fft_;
  Grid<cfloat> responses_;
  std::vector<cfloat> piece_;
};

}  // namespace odas
