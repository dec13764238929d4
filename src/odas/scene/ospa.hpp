// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/scene/truth.hpp"

namespace odas {

/// A source that is missed, or a track too many, costs as much as an error of this many degrees.
inline constexpr double kOspaCutOff = 30;

/// Optimal sub-pattern assignment: one number for errors of place and of number, in degrees; mean over the
/// hops. 0: all right; kOspaCutOff: all wrong.
///
/// Method: of the speaking sources (m) and the tracks (n), the larger number N = max(m, n): the best
/// one-to-one pairing's sum of min(distance, cut-off), and the cut-off for each that is left over, over N.
/// Source: Schuhmacher, Vo and Vo, IEEE TSP 56(8), 2008, with order p = 1. Departs from it: a track on a
/// source that makes a pause is left out (as for false tracks), for staying there is no fault.
[[nodiscard]] double ospa_deg(const KnownScene& scene, std::span<const HeardHop> heard, Measure measure);

}  // namespace odas
