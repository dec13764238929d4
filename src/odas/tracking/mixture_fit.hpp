// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "odas/tracking/config.hpp"
#include "odas/tracking/energy_histogram.hpp"

namespace odas {

using Mixture = std::vector<GaussianConfig>;

/// p(E) of a mixture.
[[nodiscard]] double density(const Mixture& mixture, double energy) noexcept;

/// The mixtures p(E | active) and p(E | inactive) of a place, from what was measured there.
struct MeasuredMixtures {
  Mixture active,
      inactive;      // sorted by mean, weights summing to 1; `active` is empty where nothing was heard
  double heard = 0;  // the part of the talk's strongest potentials that is active
};

/// The energies of the potentials of a recording.
struct Heard {
  EnergyHistogram strongest;  // of each hop
  EnergyHistogram others;
};

/// Fits both mixtures.
///
/// Method: expectation-maximization on the histograms, one to three Gaussians, as many as the Bayesian
/// information criterion pays for (neighbouring hops are alike, so eight count as one). Inactive are the
/// potentials of silence, and those of talk but the strongest: its reflections. The strongest of talk are a
/// mixture of pauses (as the strongest of silence), of reflections that outlast a word, both of known shape,
/// and of the active, which is what remains. Deviations are kept at 0.01 or more: a silence of one minute
/// knows little of the next. Last, the order is kept: the more E, the more active. A wide Gaussian of the
/// active would else win below the silence, one of the inactive above the talk.
/// Fails: where the talk was no louder than the silence, `active` is empty.
/// Source: Grondin et al., ODAS, 2022, section 3.2 (the mixtures; how to find them is left to the user).
[[nodiscard]] MeasuredMixtures fit_mixtures(const Heard& silence, const Heard& talk);

/// How well an E tells the active from the inactive.
struct Separation {
  double threshold = 0;    // E at which both are mistaken alike
  double equal_error = 1;  // how often that is
  double overlap = 1;      // the area that the two densities share: 0 none, 1 the same
};
[[nodiscard]] Separation separation(const Mixture& active, const Mixture& inactive) noexcept;

}  // namespace odas
