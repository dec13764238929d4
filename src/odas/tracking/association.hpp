// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/base/grid.hpp"
#include "odas/tracking/config.hpp"
#include "odas/tracking/energy_mixture.hpp"

namespace odas {

/// Where each potential of a hop came from: a false alarm, a new source, or one of the tracks.
///
/// Method: potential s has the likelihoods I(E_s) D Pfalse, A(E_s) D Pnew, and for track t
/// A(E_s) C_t(s) Ptrack; A and I are the Gaussian mixtures of the energy where a source sounds and where none
/// does, D is the density of a direction about which nothing is known, C_t the likelihood under the track.
/// ODAS enumerates all assignments of all potentials; as two potentials may go to one track, the sum over
/// them is a product, and each potential's own posterior is exact: (n + 2) terms instead of (n + 2)^s.
/// Computed from logarithms: a loud clean source cannot underflow every hypothesis, as it does in ODAS.
/// Cost per hop: slots x potentials exponentials, in `solve`.
/// Source: Grondin and Michaud, 2019, section 4.3; ODAS paper, 2022, eqs. 19-24.
class Association {
 public:
  /// `heard_share`: the part of the sphere from which potentials can come.
  Association(const SstConfig& config, std::size_t slots, std::size_t potentials, double heard_share);

  /// Before `solve`: log C_t(s) of each live track; others must be marked dead.
  void set_track(std::size_t slot, std::size_t potential, double log_likelihood) noexcept {
    log_tracks_[slot][potential] = log_likelihood;
  }
  void set_dead(std::size_t slot) noexcept;

  void solve(std::span<const Potential> potentials) noexcept;

  /// [potential]: probability that it came from the track.
  [[nodiscard]] std::span<const double> from_track(std::size_t slot) const noexcept {
    return from_track_[slot].first(count_);
  }
  /// Probability that any potential came from the track.
  [[nodiscard]] double activity(std::size_t slot) const noexcept { return activity_[slot]; }
  /// Probability that the potential came from a source that is not followed yet.
  [[nodiscard]] double is_new(std::size_t potential) const noexcept { return new_[potential]; }
  /// The same, were there one more track under which the potential has this log-likelihood.
  [[nodiscard]] double is_new_beside(std::size_t potential, double log_likelihood) const noexcept;

 private:
  std::size_t count_ = 0;  // potentials of this hop
  EnergyMixture active_, inactive_;
  double log_false_, log_new_, log_track_;      // priors, those of false and new with the diffuse density
  Grid<double> log_tracks_;                     // [slot][potential]
  Grid<double> from_track_;                     // [slot][potential]
  std::vector<double> activity_;                // [slot]
  std::vector<double> new_;                     // [potential]
  std::vector<double> log_total_, log_active_;  // [potential]: of all hypotheses; of A(E)
};

}  // namespace odas
