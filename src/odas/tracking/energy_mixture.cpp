// SPDX-License-Identifier: MIT
#include "odas/tracking/energy_mixture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odas {

double log_add(double a, double b) noexcept {
  const double high = std::max(a, b);
  if (high == -std::numeric_limits<double>::infinity()) return high;
  return high + std::log1p(std::exp(std::min(a, b) - high));
}

EnergyMixture::EnergyMixture(const std::vector<GaussianConfig>& config) {
  for (const GaussianConfig& g : config) {
    const auto variance = static_cast<double>(g.sigma2);
    gaussians_.push_back(
        {std::log(static_cast<double>(g.weight)) - 0.5 * std::log(2 * std::numbers::pi * variance),
         static_cast<double>(g.mu), 0.5 / variance});
  }
}

double EnergyMixture::log_density(double energy) const noexcept {
  double sum = -std::numeric_limits<double>::infinity();
  for (const Gaussian& g : gaussians_) {
    const double d = energy - g.mean;
    sum = log_add(sum, g.log_scale - d * d * g.precision);
  }
  return sum;
}

}  // namespace odas
