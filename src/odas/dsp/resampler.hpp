// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "odas/base/grid.hpp"

namespace odas {

/// Several channels from one sample rate and block size to another: blocks in, hops out.
///
/// Method: polyphase FIR. With out/in = L/M in lowest terms, output n lies at n M / L of the input; the
/// fraction picks one of L filters, a sinc under a Kaiser window, cut off at 0.925 of the lower Nyquist
/// frequency: flat to 0.84 of it, -100 dB from 1.01 of it on. Where L would make the table large, the filters
/// stand at fewer fractions and two are interpolated (error below -100 dB). At equal rates samples are
/// copied. Source: R. E. Crochiere and L. R. Rabiner, "Multirate digital signal processing", 1983, ch. 4; J.
/// O. Smith, "Digital audio resampling", CCRMA. ODAS's own (STFT low-pass and linear interpolation) loses up
/// to 7.8 dB towards its Nyquist frequency. Shapes: blocks [channel][<= max_block], hops [channel][hop].
/// Delay: none in the content: output n is the input at n / out_rate seconds. It is held back by what the
/// filter sees ahead: `lookahead()` samples of the input, 40 of the lower rate; at equal rates nothing. Cost:
/// 80 products for each output sample and channel, in / out times as many when the rate falls.
class Resampler {
 public:
  Resampler(std::size_t channels, int in_rate, int out_rate, std::size_t max_block, std::size_t hop);

  /// Takes a block. All hops that it gives must be popped before the next.
  void push(GridView<const float> block) noexcept;

  /// Gives the next hop, if there is a whole one.
  [[nodiscard]] bool pop(GridView<float> hop) noexcept;

  /// The input has ended: what was held back can be popped, so that there is an output for each n M / L
  /// within the input. `pop_rest` has what does not fill a hop.
  void finish() noexcept;

  /// Gives what is left, at most a hop, and says how many samples it is; the rest of `hop` is silence.
  [[nodiscard]] std::size_t pop_rest(GridView<float> hop) noexcept;

  /// Samples of the input that the filter looks ahead.
  [[nodiscard]] std::size_t lookahead() const noexcept { return taps_ / 2; }

  void reset() noexcept;

 private:
  void make_filters();
  void make_room(std::size_t samples) noexcept;
  [[nodiscard]] bool holds(std::size_t samples) const noexcept;
  void resample(std::size_t samples, GridView<float> out) noexcept;

  std::uint64_t up_, down_;  // L, M
  std::size_t max_block_, hop_;
  std::size_t taps_;       // 1 at equal rates
  std::size_t fractions_;  // filters; fewer than L: two are interpolated
  Grid<float> filters_;    // [fraction][tap]; one more than fractions_
  Grid<float> input_;      // [channel][capacity]: samples begin_ .. end_ are still needed

  std::size_t begin_ = 0, end_ = 0;  // begin_: first tap of the next output
  std::vector<std::size_t> quiet_;   // [channel]: from here on all its samples are zero
  std::uint64_t fraction_ = 0;       // of the next output, in 1 / L of a sample
  std::uint64_t taken_ = 0;          // samples of the input
  std::uint64_t given_ = 0;          // samples of the output
  bool finished_ = false;
};

}  // namespace odas
