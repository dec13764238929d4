// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "odas/tracking/config.hpp"

namespace odas {

/// ln(exp(a) + exp(b)).
[[nodiscard]] double log_add(double a, double b) noexcept;

/// A density of E: the Gaussian mixture of `sst.active` or of `sst.inactive`.
class EnergyMixture {
 public:
  explicit EnergyMixture(const std::vector<GaussianConfig>& config);
  /// Natural logarithm; -infinity for no Gaussian.
  [[nodiscard]] double log_density(double energy) const noexcept;

 private:
  struct Gaussian {
    double log_scale, mean, precision;
  };
  std::vector<Gaussian> gaussians_;
};

}  // namespace odas
