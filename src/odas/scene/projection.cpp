// SPDX-License-Identifier: MIT
#include "odas/scene/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "odas/base/grid.hpp"
#include "odas/scene/correlation.hpp"

namespace odas {
namespace {

constexpr std::size_t kAdvance = kProjectionTaps / 2;  // the filter may look as far ahead as back
constexpr double kRidge = 1e-6;                        // of the power: keeps silent bands solvable
constexpr double kSilent = 1e-9;                       // of the target's power: nothing to interfere
constexpr double kTiny = 1e-12;

double power(std::span<const float> x) {
  return std::transform_reduce(x.begin(), x.end(), 0.0, std::plus<>(),
                               [](float v) { return static_cast<double>(v) * static_cast<double>(v); });
}

double ratio_db(double wanted, double unwanted) {
  return 10 * std::log10(wanted / (unwanted + kTiny) + kTiny);
}

/// In four sums side by side, which the compiler can keep in vectors.
double dot(std::span<const double> a, std::span<const double> b) {
  std::array<double, 4> sums{};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += a[i + lane] * b[i + lane];
  }
  for (; i < a.size(); ++i) sums[0] += a[i] * b[i];
  return sums[0] + sums[1] + (sums[2] + sums[3]);
}

/// Replaces the symmetric positive definite `a` by its lower Cholesky factor, row by row.
void factorise(Grid<double>& a) {
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double rest = a[i][j] - dot(a[i].first(j), a[j].first(j));
      a[i][j] = i == j ? std::sqrt(std::max(rest, kTiny * kTiny)) : rest / a[j][j];
    }
  }
}

/// y' A^-1 y, from the factor of A: the energy of the projection whose correlations are `y`.
double explained(const Grid<double>& factor, std::span<const double> y) {
  std::vector<double> half(y.begin(), y.end());
  for (std::size_t i = 0; i < half.size(); ++i) {
    half[i] = (half[i] - dot(factor[i].first(i), std::span<const double>(half).first(i))) / factor[i][i];
  }
  return dot(half, half);
}

/// E[reference_p[n - i] reference_q[n - j]] over all taps of all references, and their ridge.
Grid<double> gram_of(std::span<const std::span<const float>> references) {
  constexpr std::size_t kTaps = kProjectionTaps;
  Grid<double> gram(references.size() * kTaps, references.size() * kTaps);
  for (std::size_t p = 0; p < references.size(); ++p) {
    for (std::size_t q = 0; q <= p; ++q) {
      // lag i - j from -(taps - 1): c[l] = sum of q[n + l] p[n]
      const auto c = correlate(references[q], references[p], 1 - static_cast<long>(kTaps), 2 * kTaps - 1);
      for (std::size_t i = 0; i < kTaps; ++i) {
        for (std::size_t j = 0; j < kTaps; ++j) gram[p * kTaps + i][q * kTaps + j] = c[kTaps - 1 + i - j];
      }
      if (p != q) continue;
      for (std::size_t i = 0; i < kTaps; ++i) gram[p * kTaps + i][p * kTaps + i] *= 1 + kRidge;
    }
  }
  return gram;
}

std::vector<double> correlations(std::span<const float> estimate, std::span<const float> reference) {
  return correlate(estimate, reference, -static_cast<long>(kAdvance), kProjectionTaps);
}

}  // namespace

std::vector<double> solve_toeplitz(std::span<const double> first_row, std::span<const double> y) {
  const std::size_t size = y.size();
  std::vector<double> x(size, 0.0), predictor(size, 0.0), next(size, 0.0);
  predictor[0] = 1;  // T_n predictor = (error, 0, ..., 0)
  double error = first_row[0];
  x[0] = y[0] / error;
  for (std::size_t n = 1; n < size; ++n) {
    double left = 0;
    for (std::size_t i = 0; i < n; ++i) left += predictor[i] * first_row[n - i];
    const double reflection = -left / error;
    for (std::size_t i = 0; i <= n; ++i)
      next[i] = predictor[i] + reflection * (i == 0 ? 0 : predictor[n - i]);
    next.swap(predictor);
    error *= 1 - reflection * reflection;
    double rest = y[n];
    for (std::size_t i = 0; i < n; ++i) rest -= x[i] * first_row[n - i];
    for (std::size_t i = 0; i <= n; ++i) x[i] += rest / error * predictor[n - i];
  }
  return x;
}

double sdr_db(std::span<const float> estimate, std::span<const float> target) {
  auto self = correlate(target, target, 0, kProjectionTaps);
  self[0] *= 1 + kRidge;
  if (!(self[0] > 0)) return ratio_db(0, power(estimate));
  const auto taps = solve_toeplitz(self, correlations(estimate, target));
  const auto explained_part = filter(target, taps, kAdvance);
  std::vector<float> rest(estimate.begin(), estimate.end());
  for (std::size_t n = 0; n < rest.size(); ++n) rest[n] -= explained_part[n];
  return ratio_db(power(explained_part), power(rest));
}

double si_sdr_db(std::span<const float> estimate, std::span<const float> target) {
  const double of_target = power(target);
  if (!(of_target > 0)) return ratio_db(0, power(estimate));
  double common = 0;
  for (std::size_t n = 0; n < target.size(); ++n) {
    common += static_cast<double>(estimate[n]) * static_cast<double>(target[n]);
  }
  const double wanted = common * common / of_target;
  return ratio_db(wanted, std::max(0.0, power(estimate) - wanted));
}

double sir_db(std::span<const float> estimate, std::span<const float> target,
              std::span<const std::vector<float>> others) {
  std::vector<std::span<const float>> references{target};
  const double of_target = power(target);
  if (!(of_target > 0)) return ratio_db(0, 1);
  for (const auto& other : others) {
    if (power(other) > kSilent * of_target) references.emplace_back(other);
  }
  if (references.size() == 1) return std::numeric_limits<double>::infinity();
  Grid<double> factor = gram_of(references);
  factorise(factor);
  std::vector<double> y;
  for (const auto& reference : references) {
    const auto part = correlations(estimate, reference);
    y.insert(y.end(), part.begin(), part.end());
  }
  // The target's rows come first, so their factor is the factor of the target alone.
  const double wanted = explained(factor, std::span<const double>(y).first(kProjectionTaps));
  return ratio_db(wanted, explained(factor, y) - wanted);
}

}  // namespace odas
