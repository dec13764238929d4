// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "odas/tracking/simd.hpp"

namespace odas {

/// Random numbers of mean 0 and variance 1, four at a time, the same bits on each platform: whole numbers,
/// one conversion and one product, where a library's normal distribution is its own on each.
///
/// Method: four generators xoshiro128++ side by side; the sum of four of their 16-bit numbers, which is
/// nearly normal (excess kurtosis -0.3) and never beyond 3.47: no particle is thrown off the sphere.
/// Source: Blackman and Vigna, "Scrambled linear pseudorandom number generators", 2021.
class NormalNoise {
 public:
  explicit NormalNoise(std::uint32_t seed) noexcept {
    for (auto& word : state_) {
      for (int lane = 0; lane < kLanes; ++lane) word[lane] = mixed(seed += 0x9E3779B9U);
    }
  }

  [[nodiscard]] Floats operator()() noexcept {
    constexpr float kMean = 2 * 65535.F;
    constexpr float kScale = 1.7320508F / 65536;  // sqrt(12 / 4) over the width of one number
    const Words a = next();
    const Words b = next();
    const Words sum = (a & 0xFFFFU) + (a >> 16U) + (b & 0xFFFFU) + (b >> 16U);
    return kScale * (to_floats(sum) - kMean);
  }

  /// One number, the same density everywhere in [0, 1).
  [[nodiscard]] float uniform() noexcept { return static_cast<float>(next()[0] >> 8U) / 16777216.F; }

 private:
  static std::uint32_t mixed(std::uint32_t x) noexcept {
    x = (x ^ (x >> 16U)) * 0x85EBCA6BU;
    x = (x ^ (x >> 13U)) * 0xC2B2AE35U;
    return x ^ (x >> 16U);
  }

  Words next() noexcept {
    const auto rotated = [](Words x, unsigned by) { return (x << by) | (x >> (32U - by)); };
    const Words result = rotated(state_[0] + state_[3], 7) + state_[0];
    const Words shifted = state_[1] << 9U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotated(state_[3], 11);
    return result;
  }

  Words state_[4]{};
};

}  // namespace odas
