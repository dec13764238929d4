// SPDX-License-Identifier: MIT
// Four numbers in one register of any machine; arithmetic is element by element.
#pragma once

#include <cstdint>

namespace odas {

inline constexpr int kLanes = 4;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Words = std::uint32_t __attribute__((vector_size(4 * kLanes)));

/// Words below 2^31 only.
[[nodiscard]] inline Floats to_floats(Words x) noexcept {
  using Ints = std::int32_t __attribute__((vector_size(4 * kLanes)));
  return __builtin_convertvector(reinterpret_cast<Ints>(x), Floats);
}

[[nodiscard]] inline float sum_of(Floats x) noexcept { return (x[0] + x[2]) + (x[1] + x[3]); }

/// exp(-x) of x >= 0, to 1e-5 of itself; what is smaller than exp(-60) counts as that (its
/// products with small weights are no denormals yet), and so does a NaN.
///
/// Method: exp(-x) = 2^n 2^f, n whole, |f| <= 1/2; n goes into the exponent's bits, 2^f is a polynomial.
/// Sums and products alone: the same bits on each platform.
[[nodiscard]] inline Floats exp_minus(Floats x) noexcept {
  constexpr float kRounder = 12582912;  // 1.5 * 2^23: what is added to it loses its fraction
  const Floats limit = Floats{} + 60.F;
  const Floats t = -1.44269504F * (x < limit ? x : limit);
  const Floats rounded = t + kRounder;
  const Floats f = t - (rounded - kRounder);
  const Floats power =
      1.F + f * (0.69314718F + f * (0.24022651F + f * (0.05550411F + f * (0.00961813F + f * 0.00133336F))));
  const auto bits = reinterpret_cast<Words>(power) + (reinterpret_cast<Words>(rounded) << 23U);
  return reinterpret_cast<Floats>(bits);
}

}  // namespace odas
