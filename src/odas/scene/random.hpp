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

 private:
  std::mt19937 generator_;
};

}  // namespace odas
