// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace odas {

/// Impulses between the samples, very many of them: the echoes of a room.
///
/// Method: each impulse is laid down on a grid of kOver points a sample, over four of them by Lagrange's
/// cubic; `render` then takes the samples from the grid, through the windowed sinc of DelayFilter. It differs
/// from DelayFilter by less than -60 dB up to a half of the band, and -40 dB at its upper end.
/// Cost: four sums an impulse, and kOver * DelayFilter::kTaps products a sample once.
class ImpulseTrain {
 public:
  static constexpr std::size_t kOver = 4;

  explicit ImpulseTrain(std::size_t samples);

  void clear() noexcept;
  /// `delay`: samples, not negative. What would lie behind the end is lost.
  void add(float delay, float gain) noexcept;
  /// response[n] += the sum of all impulses at sample n. `response` is of the length that this was made for.
  void render(std::span<float> response) const noexcept;

 private:
  std::vector<float> kernel_;
  std::vector<float> grid_;
};

}  // namespace odas
