// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace odas {

/// Power of the steady noise in a stream that somebody speaks in now and then.
///
/// Method, per bin: t = (P / N / 3.6)^4, p = t / (1 + t), N <- N + a (1 - p) (P - N): what is far over the
/// noise
///   is taken for speech, and not learned. Where p has been near 1 for long, p is held under 0.99, or a noise
///   that became louder would never be learned.
/// Symbols: P: power of this hop; N: of the noise; a: of a time constant of 0.13 s; p: presence of speech.
/// Source: Gerkmann and Hendriks, "Unbiased MMSE-based noise power estimation with low complexity and low
///   tracking delay", IEEE TASLP 20(4), 2012. Departs: p is a ratio of powers with the same threshold in
///   place of their logistic function, so that no exponential is needed.
/// Shapes: power, noise [bin]. Cost per hop: some 15 operations a bin.
/// Errors: powers must be finite. Fails: speech without any pause in a bin for a second begins to count as
/// noise.
class PresenceNoise {
 public:
  PresenceNoise(std::size_t bins, float hop_seconds);

  void update(std::span<const float> power) noexcept;
  /// Goes on as if it had heard what `other` did.
  void take_over(const PresenceNoise& other) noexcept;
  [[nodiscard]] std::span<const float> power() const noexcept { return noise_; }
  void reset() noexcept;

 private:
  float learn_, mean_;  // weights of the new value per hop
  std::size_t hops_ = 0;
  std::vector<float> noise_, presence_;
};

}  // namespace odas
