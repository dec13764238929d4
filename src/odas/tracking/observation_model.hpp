// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/tracking/config.hpp"
#include "odas/tracking/energy_mixture.hpp"

namespace odas {

/// Of azimuth: nearer than two people stand.
inline constexpr double kSamePlace = 7 * kDegree;

/// In radians, 0 to pi.
[[nodiscard]] double azimuth_between(Vec3 a, Vec3 b) noexcept;

/// A potential of a hop as BernoulliTracker takes it. Ratios are likelihoods, of a source against none.
struct Observation {
  Vec3 direction{};
  TangentCovariance covariance{};
  double loudness = 0;   // ln E; 0: not told
  double ratio = 1;      // exp(evidence)
  double new_ratio = 1;  // of somebody new: what is less loud than another may be his reflection
  double old_ratio = 1;  // of somebody known
  double pull = 1;       // probability of old_ratio: as how much of an observation it counts
  bool leads = false;    // nothing elsewhere is louder
  // What the tracker makes of it:
  double seen_fit = 0;  // density of sources that are seen, whether they sound or not
  double others = 0;    // density of all its hypotheses together
  double seen = 0;      // probability that it comes of a source that is seen, or a target
  double known = 0;     // or of a candidate
};

/// Takes the potentials of a hop that are sound, adds what the localizer did not tell, and sets them against
/// each other.
class ObservationModel {
 public:
  explicit ObservationModel(const SstConfig& config);
  /// Writes `observations`, which has room for all of them.
  void take(std::span<const Potential> potentials, std::vector<Observation>& observations) const noexcept;

 private:
  EnergyMixture active_, inactive_;
  float untold_variance_;  // of a direction, rad^2
};

}  // namespace odas
