// SPDX-License-Identifier: MIT
#include "odas/dsp/cholesky.hpp"

#include "support/wave_field.hpp"
#include <gtest/gtest.h>

namespace odas::cholesky_test {
namespace {

/// [row][column] of x x^H of several x: Hermitian, of full rank.
std::vector<cfloat> covariance(std::size_t n) {
  const Grid<cfloat> x = test::Noise(3)(3 * n, n);
  std::vector<cfloat> a(n * n);
  for (std::size_t t = 0; t < x.rows(); ++t) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) a[i * n + j] += x[t][i] * std::conj(x[t][j]);
    }
  }
  return a;
}

TEST(Cholesky, gives_a_factor_whose_square_is_the_matrix) {
  for (const std::size_t n : {1U, 2U, 7U}) {
    const std::vector<cfloat> a = covariance(n);
    std::vector<cfloat> l = a;
    cholesky(l, n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        cfloat sum{};
        for (std::size_t k = 0; k <= j; ++k) sum += l[i * n + k] * std::conj(l[j * n + k]);
        EXPECT_LT(std::abs(sum - a[i * n + j]), 1e-5F * std::abs(a[0])) << n << i << j;
      }
    }
  }
}

TEST(Cholesky, puts_the_floor_where_no_power_is_left) {
  std::vector<cfloat> ones(4, 1);  // of rank 1
  cholesky(ones, ones.size() / 2, 0.25F);
  EXPECT_EQ(ones[3], cfloat(0.5F));
}

TEST(Whiten, makes_a_sound_white_and_gives_its_power) {
  constexpr std::size_t n = 3;
  std::vector<cfloat> l = covariance(n);
  cholesky(l, n, 0);
  const std::vector<cfloat> white{{1, 2}, {-1, 0}, {0, 3}};
  std::vector<cfloat> x(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k <= i; ++k) x[i] += l[i * n + k] * white[k];
  }
  EXPECT_NEAR(whiten(l, x), 15, 1e-3);
  EXPECT_LT(test::relative_distance(x, white), 1e-5);
}

}  // namespace
}  // namespace odas::cholesky_test
