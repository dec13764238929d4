// SPDX-License-Identifier: MIT
#include "odas/tracking/association.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odas {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

double log_add(double a, double b) noexcept {
  const double high = std::max(a, b);
  if (high == kImpossible) return kImpossible;
  return high + std::log1p(std::exp(std::min(a, b) - high));
}

}  // namespace

Association::Association(const SstConfig& config, std::size_t slots, std::size_t potentials,
                         double heard_share)
    : active_(mixture(config.active)),
      inactive_(mixture(config.inactive)),
      log_tracks_(slots, potentials),
      from_track_(slots, potentials),
      activity_(slots),
      new_(potentials),
      log_total_(potentials),
      log_active_(potentials) {
  const double log_diffuse = -std::log(4 * std::numbers::pi * heard_share);
  log_false_ = std::log(static_cast<double>(config.p_false)) + log_diffuse;
  log_new_ = std::log(static_cast<double>(config.p_new)) + log_diffuse;
  log_track_ = std::log(static_cast<double>(config.p_track));
}

std::vector<Association::Gaussian> Association::mixture(const std::vector<GaussianConfig>& config) {
  std::vector<Gaussian> gaussians;
  for (const GaussianConfig& g : config) {
    const auto variance = static_cast<double>(g.sigma2);
    gaussians.push_back(
        {std::log(static_cast<double>(g.weight)) - 0.5 * std::log(2 * std::numbers::pi * variance),
         static_cast<double>(g.mu), 0.5 / variance});
  }
  return gaussians;
}

double Association::log_density(const std::vector<Gaussian>& mixture, double energy) noexcept {
  double sum = kImpossible;
  for (const Gaussian& g : mixture) {
    const double d = energy - g.mean;
    sum = log_add(sum, g.log_scale - d * d * g.precision);
  }
  return sum;
}

void Association::set_dead(std::size_t slot) noexcept {
  std::fill(log_tracks_[slot].begin(), log_tracks_[slot].end(), kImpossible);
}

void Association::solve(std::span<const Potential> potentials) noexcept {
  ODAS_EXPECT(potentials.size() <= new_.size());
  count_ = potentials.size();
  std::fill(activity_.begin(), activity_.end(), 1.0);  // for now: that no potential came from the track
  for (std::size_t s = 0; s < potentials.size(); ++s) {
    const Potential& potential = potentials[s];
    const auto energy = static_cast<double>(potential.energy);
    log_active_[s] = log_density(active_, energy);
    const double log_new = log_active_[s] + log_new_;
    const double log_false = log_density(inactive_, energy) + log_false_;
    double high = std::max(log_false, log_new);
    for (std::size_t t = 0; t < log_tracks_.rows(); ++t) {
      high = std::max(high, log_active_[s] + log_tracks_[t][s] + log_track_);
    }
    // A potential that no hypothesis explains at all (E far off every mixture) counts as a false alarm, and
    // so does one that is not finite.
    if (!std::isfinite(high) || !std::isfinite(energy) || !std::isfinite(norm(potential.direction))) {
      log_total_[s] = log_active_[s] = kImpossible;
      new_[s] = 0;
      for (std::size_t t = 0; t < log_tracks_.rows(); ++t) from_track_[t][s] = 0;
      continue;
    }
    double total = std::exp(log_false - high) + std::exp(log_new - high);
    for (std::size_t t = 0; t < log_tracks_.rows(); ++t) {
      from_track_[t][s] = std::exp(log_active_[s] + log_tracks_[t][s] + log_track_ - high);
      total += from_track_[t][s];
    }
    log_total_[s] = high + std::log(total);
    new_[s] = std::exp(log_new - high) / total;
    for (std::size_t t = 0; t < log_tracks_.rows(); ++t) {
      from_track_[t][s] /= total;
      activity_[t] *= 1 - from_track_[t][s];
    }
  }
  for (double& a : activity_) a = 1 - a;
}

double Association::is_new_beside(std::size_t potential, double log_likelihood) const noexcept {
  const double more = log_add(log_total_[potential], log_active_[potential] + log_likelihood + log_track_);
  return std::isfinite(more) ? std::exp(log_active_[potential] + log_new_ - more) : 0;
}

}  // namespace odas
