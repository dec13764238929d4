// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "odas/array/types.hpp"

namespace odas {

/// A <- L, lower triangle with a real diagonal, of the Hermitian A = L L^H, row by row; what lies above the
/// diagonal is neither read nor written. A pivot that rounding has left without power becomes `floor`.
inline void cholesky(std::span<cfloat> a, std::size_t n, float floor) noexcept {
  for (std::size_t j = 0; j < n; ++j) {
    float pivot = a[j * n + j].real();
    for (std::size_t k = 0; k < j; ++k) pivot -= std::norm(a[j * n + k]);
    const float diagonal = std::sqrt(std::max(pivot, floor));
    a[j * n + j] = diagonal;
    for (std::size_t i = j + 1; i < n; ++i) {
      cfloat sum = a[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i * n + k] * std::conj(a[j * n + k]);
      a[i * n + j] = sum / diagonal;
    }
  }
}

/// |L^-1 x|^2, which is x^H A^-1 x. x <- L^-1 x.
inline float whiten(std::span<const cfloat> l, std::span<cfloat> x) noexcept {
  const std::size_t n = x.size();
  float power = 0;
  for (std::size_t i = 0; i < n; ++i) {
    cfloat sum = x[i];
    for (std::size_t k = 0; k < i; ++k) sum -= l[i * n + k] * x[k];
    x[i] = sum / l[i * n + i].real();
    power += std::norm(x[i]);
  }
  return power;
}

}  // namespace odas
