// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "odas/base/grid.hpp"

namespace odas {

/// Several channels from one sample rate and block size to another: blocks in, hops out.
///
/// Method: band-limited sinc interpolation (libsamplerate, "fastest": pass band to 0.8 of the lower Nyquist
/// frequency, aliases under -97 dB); at equal rates only the block size changes and samples are copied.
/// Source: J. O. Smith, "Digital audio resampling", CCRMA; ODAS's own (STFT low-pass and linear
/// interpolation) loses up to 7.8 dB towards its Nyquist frequency. Shapes: blocks [channel][<= max_block],
/// hops [channel][hop]. Delay: none in the content: output sample k is the input at k / out_rate seconds. It
/// is held back by what the filter must see ahead: at most `lookahead()` samples of the input; at equal rates
/// nothing.
class Resampler {
 public:
  /// Throws ConfigError where the ratio of the rates is beyond 1/256 .. 256.
  Resampler(std::size_t channels, int in_rate, int out_rate, std::size_t max_block, std::size_t hop);
  ~Resampler();
  Resampler(Resampler&&) noexcept;
  Resampler& operator=(Resampler&&) noexcept;

  /// Takes a block. All hops that it gives must be popped before the next.
  void push(GridView<const float> block) noexcept;

  /// Gives the next hop, if there is a whole one.
  [[nodiscard]] bool pop(GridView<float> hop) noexcept;

  /// The input has ended: brings out what was held back, so that there are round(in * out_rate / in_rate)
  /// samples in all. `pop_rest` has what does not fill a hop.
  void finish() noexcept;

  /// Gives what is left, at most a hop, and says how many samples it is; the rest of `hop` is silence.
  [[nodiscard]] std::size_t pop_rest(GridView<float> hop) noexcept;

  /// Samples of the input that the filter looks ahead.
  [[nodiscard]] std::size_t lookahead() const noexcept;

  void reset() noexcept;

 private:
  struct Converter;

  void convert(const float* interleaved, std::size_t frames, bool end) noexcept;
  void append(GridView<const float> block) noexcept;
  [[nodiscard]] std::size_t held() const noexcept { return end_ - begin_; }

  std::size_t max_block_;
  std::size_t hop_;
  std::unique_ptr<Converter> converter_;  // none at equal rates
  Grid<float> held_;                      // [channel][capacity]: samples begin_ .. end_ wait to be popped
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace odas
