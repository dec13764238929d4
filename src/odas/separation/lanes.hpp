// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "odas/array/types.hpp"

namespace odas {

/// As many floats as fit one vector register of any machine. Arithmetic is element by element.
using Floats = float __attribute__((vector_size(16)));

/// Complex numbers of neighbouring bins side by side, real and imaginary parts apart.
struct Lanes {
  static constexpr std::size_t kSize = 4;
  Floats re{};
  Floats im{};
};

/// Lanes that hold `bins` numbers; the last may have some to spare, which stay zero.
[[nodiscard]] constexpr std::size_t lanes_for(std::size_t bins) noexcept {
  return (bins + Lanes::kSize - 1) / Lanes::kSize;
}

/// Fills to[lane * stride]; places past the last bin become zero.
inline void split(std::span<const cfloat> from, Lanes* to, std::size_t stride) noexcept {
  for (; from.size() >= Lanes::kSize; from = from.subspan(Lanes::kSize), to += stride) {
    const auto* x = reinterpret_cast<const float*>(from.data());
    *to = Lanes{Floats{x[0], x[2], x[4], x[6]}, Floats{x[1], x[3], x[5], x[7]}};
  }
  if (!from.empty()) *to = Lanes{};
  for (std::size_t i = 0; i < from.size(); ++i) {
    to->re[i] = from[i].real();
    to->im[i] = from[i].imag();
  }
}

/// The reverse of split().
inline void join(const Lanes* from, std::size_t stride, std::span<cfloat> to) noexcept {
  for (; to.size() >= Lanes::kSize; to = to.subspan(Lanes::kSize), from += stride) {
    for (std::size_t i = 0; i < Lanes::kSize; ++i) to[i] = {from->re[i], from->im[i]};
  }
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = {from->re[i], from->im[i]};
}

/// sum += a b
inline void add_product(Lanes& sum, const Lanes& a, const Lanes& b) noexcept {
  sum.re += a.re * b.re - a.im * b.im;
  sum.im += a.re * b.im + a.im * b.re;
}

/// sum -= a conj(b)
inline void subtract_product_conj(Lanes& sum, const Lanes& a, const Lanes& b) noexcept {
  sum.re -= a.re * b.re + a.im * b.im;
  sum.im -= a.im * b.re - a.re * b.im;
}

/// factor a
[[nodiscard]] inline Lanes scaled(const Lanes& a, Floats factor) noexcept {
  return {a.re * factor, a.im * factor};
}

[[nodiscard]] inline Lanes conjugate(const Lanes& a) noexcept { return {a.re, -a.im}; }

/// |a|^2
[[nodiscard]] inline Floats squared(const Lanes& a) noexcept { return a.re * a.re + a.im * a.im; }

/// The same number in each place.
[[nodiscard]] inline Floats all(float value) noexcept { return Floats{} + value; }

}  // namespace odas
