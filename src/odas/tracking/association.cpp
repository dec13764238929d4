// SPDX-License-Identifier: MIT
#include "odas/tracking/association.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odas {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

}  // namespace

Association::Association(const SstConfig& config, std::size_t slots, std::size_t potentials,
                         double heard_share)
    : active_(config.active),
      inactive_(config.inactive),
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
    log_active_[s] = active_.log_density(energy);
    const double log_new = log_active_[s] + log_new_;
    const double log_false = inactive_.log_density(energy) + log_false_;
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
