// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

namespace odas {

/// Random numbers that are the same on every platform: the standard fixes the generator, not its
/// distributions, so these are our own, of additions and products alone.
class Random {
 public:
  explicit Random(std::uint32_t seed) : generator_(seed) {}

  /// A generator for one part of a scene, that does not depend on what the other parts draw.
  [[nodiscard]] static Random of(std::uint32_t seed, std::uint32_t part) {
    return Random(seed * 2654435761U ^ (part + 1) * 2246822519U);
  }

  /// Uniform, mean 0, variance 1: +-sqrt(3).
  [[nodiscard]] float uniform() {
    constexpr float kStep = 3.46410161513775F / 16777216.F;
    return (static_cast<float>(generator_() >> 8U) - 8388607.5F) * kStep;
  }

  /// Uniform, 0 to below 1.
  [[nodiscard]] float share() { return static_cast<float>(generator_() >> 8U) / 16777216.F; }
  [[nodiscard]] float between(float low, float high) { return low + (high - low) * share(); }
  /// One of 0 .. count - 1.
  [[nodiscard]] std::size_t below(std::size_t count) {
    return static_cast<std::size_t>((std::uint64_t{generator_()} * count) >> 32U);
  }

 private:
  std::mt19937 generator_;
};

}  // namespace odas
