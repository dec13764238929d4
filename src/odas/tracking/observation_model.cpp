// SPDX-License-Identifier: MIT
#include "odas/tracking/observation_model.hpp"

#include <algorithm>
#include <cmath>

namespace odas {
namespace {

// Chosen as docs/tracking.md says.
constexpr double kBehind = 0.33;                 // nats; louder by less is not louder
constexpr double kLess = 0.45, kLessOld = 0.65;  // of what is louder by a nat, so much less evidence
constexpr double kSurest = 12;                   // nats
// rad^2: talkers are no points, and rooms no open fields.
constexpr float kBlur2East = 0.0036F, kBlur2North = 0.006F;

}  // namespace

double azimuth_between(Vec3 a, Vec3 b) noexcept {
  return std::abs(
      std::atan2(static_cast<double>(a.x * b.y - a.y * b.x), static_cast<double>(a.x * b.x + a.y * b.y)));
}

ObservationModel::ObservationModel(const SstConfig& config)
    : active_(config.active), inactive_(config.inactive), untold_variance_(config.sigma_r2_active) {}

void ObservationModel::take(std::span<const Potential> potentials,
                            std::vector<Observation>& observations) const noexcept {
  observations.clear();
  for (const Potential& potential : potentials) {
    const float length = norm(potential.direction);
    if (!std::isfinite(length) || !(length > 0) || !std::isfinite(potential.energy)) continue;
    Observation heard;
    heard.direction = normalized(potential.direction);
    heard.covariance = potential.covariance;
    heard.covariance.east += kBlur2East;
    heard.covariance.north += kBlur2North;
    double evidence = static_cast<double>(potential.evidence);
    if (!(potential.covariance.east > 0)) {
      const auto energy = static_cast<double>(potential.energy);
      evidence = active_.log_density(energy) - inactive_.log_density(energy);
      heard.covariance = {untold_variance_, untold_variance_, 0};
    } else if (potential.energy > 0) {
      heard.loudness = std::log(static_cast<double>(potential.energy));
    }
    if (!std::isfinite(evidence)) continue;
    heard.ratio = std::exp(std::clamp(evidence, -kSurest, kSurest));
    observations.push_back(heard);
  }
  for (Observation& heard : observations) {
    double less = 0;
    double behind = 0;
    for (const Observation& louder : observations) {
      if (louder.ratio <= heard.ratio) continue;
      const double louder_by = std::log(louder.ratio / heard.ratio);
      less = std::max(less, louder_by);
      if (azimuth_between(louder.direction, heard.direction) > kSamePlace)
        behind = std::max(behind, louder_by);
    }
    heard.leads = behind < kBehind;
    heard.new_ratio = heard.ratio * std::exp(-kLess * less);
    heard.old_ratio = heard.ratio * std::exp(-kLessOld * less);
    heard.pull = heard.old_ratio / (1 + heard.old_ratio);
  }
}

}  // namespace odas
