// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace odas {

/// Adds impulses that lie between the samples.
///
/// Method: a sinc under a Hann window of kTaps samples, from a table of kPhases fractions with straight lines
/// between them. Errors are under -60 dB up to
/// 0.75 of half the sample rate, and -45 dB at 0.85; above, the gain falls.
/// Source: Laakso et al., "Splitting the unit delay", IEEE SPM 13(1), 1996.
class DelayFilter {
 public:
  static constexpr std::size_t kTaps = 40;
  static constexpr std::size_t kBefore = kTaps / 2 - 1;  // taps before the sample at or under the delay
  static constexpr std::size_t kPhases = 128;

  DelayFilter();

  /// response[delay] += gain, spread over the samples around. What would lie outside of `response` is lost.
  void add(float delay, float gain, std::span<float> response) const noexcept;

 private:
  std::vector<float> table_;  // [phase][tap]
};

}  // namespace odas
