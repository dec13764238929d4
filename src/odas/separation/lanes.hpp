// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "odas/array/types.hpp"

namespace odas {

/// Eight complex numbers side by side, real and imaginary parts apart: what is computed with them in a
/// plain loop, the compiler does in vectors.
struct Lanes {
  static constexpr std::size_t kSize = 8;
  std::array<float, kSize> re{};
  std::array<float, kSize> im{};
};

/// Lanes that hold `bins` numbers; the last may have some to spare, which stay zero.
[[nodiscard]] constexpr std::size_t lanes_for(std::size_t bins) noexcept {
  return (bins + Lanes::kSize - 1) / Lanes::kSize;
}

inline void split(std::span<const cfloat> from, std::span<Lanes> to) noexcept {
  for (std::size_t l = 0; l < to.size(); ++l) {
    const std::size_t begin = l * Lanes::kSize;
    const std::size_t n = std::min(Lanes::kSize, from.size() - begin);
    for (std::size_t i = 0; i < n; ++i) {
      to[l].re[i] = from[begin + i].real();
      to[l].im[i] = from[begin + i].imag();
    }
  }
}

inline void join(std::span<const Lanes> from, std::span<cfloat> to) noexcept {
  for (std::size_t l = 0; l < from.size(); ++l) {
    const std::size_t begin = l * Lanes::kSize;
    const std::size_t n = std::min(Lanes::kSize, to.size() - begin);
    for (std::size_t i = 0; i < n; ++i) to[begin + i] = {from[l].re[i], from[l].im[i]};
  }
}

/// sum += a b
inline void add_product(Lanes& sum, const Lanes& a, const Lanes& b) noexcept {
  for (std::size_t i = 0; i < Lanes::kSize; ++i) {
    sum.re[i] += a.re[i] * b.re[i] - a.im[i] * b.im[i];
    sum.im[i] += a.re[i] * b.im[i] + a.im[i] * b.re[i];
  }
}

/// sum -= a conj(b)
inline void subtract_product_conj(Lanes& sum, const Lanes& a, const Lanes& b) noexcept {
  for (std::size_t i = 0; i < Lanes::kSize; ++i) {
    sum.re[i] -= a.re[i] * b.re[i] + a.im[i] * b.im[i];
    sum.im[i] -= a.im[i] * b.re[i] - a.re[i] * b.im[i];
  }
}

/// a *= factor
inline void scale(Lanes& a, float factor) noexcept {
  for (std::size_t i = 0; i < Lanes::kSize; ++i) {
    a.re[i] *= factor;
    a.im[i] *= factor;
  }
}

/// a *= factors
inline void scale(Lanes& a, const std::array<float, Lanes::kSize>& factors) noexcept {
  for (std::size_t i = 0; i < Lanes::kSize; ++i) {
    a.re[i] *= factors[i];
    a.im[i] *= factors[i];
  }
}

/// factor conj(a)
[[nodiscard]] inline Lanes conjugate(const Lanes& a, float factor) noexcept {
  Lanes out;
  for (std::size_t i = 0; i < Lanes::kSize; ++i) {
    out.re[i] = factor * a.re[i];
    out.im[i] = -factor * a.im[i];
  }
  return out;
}

/// |a|^2
[[nodiscard]] inline std::array<float, Lanes::kSize> squared(const Lanes& a) noexcept {
  std::array<float, Lanes::kSize> out;
  for (std::size_t i = 0; i < Lanes::kSize; ++i) out[i] = a.re[i] * a.re[i] + a.im[i] * a.im[i];
  return out;
}

}  // namespace odas
