// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "odas/scene/truth.hpp"

namespace odas {

/// A track counts for a source when it is nearer than this, in degrees.
inline constexpr double kHitDegrees = 15;

/// Talkers nearer than this to each other, in degrees, cannot be told apart by where they are.
inline constexpr double kApartDegrees = 20;

/// An onset that never comes counts as this many seconds.
inline constexpr double kNeverSeconds = 99;

/// Tracks against the truth. Empty where there is nothing to be measured: no sources, nobody speaks.
struct TrackScore {
  std::optional<double> recall;            // share of (speaking source, hop) that a track follows
  std::optional<double> error_deg;         // mean over these
  double false_s_per_min = 0;              // track seconds away from every source, speaking or silent
  std::optional<double> duplicates;        // tracks per hop on a source that another track follows
  std::optional<double> switches_per_min;  // changes of the id on a source, per source
  /// The same without the hops in which another source is nearer than kApartDegrees: who has another id after
  /// a crossing counts once, and who passes under whose id does not.
  std::optional<double> switches_apart_per_min;
  std::optional<double> onset_s;  // from the first word to the first hit; median over the sources

  /// [source][hop]: its track, whether it speaks or not; id 0: none
  std::vector<std::vector<HeardTrack>> followed;
};

/// Method: in each hop tracks and sources are paired one to one, by the smallest sum of distances, pairs
/// beyond kHitDegrees counting as none. Cost: linear in the hops.
[[nodiscard]] TrackScore score_tracks(const KnownScene& scene, std::span<const HeardHop> heard,
                                      Measure measure);

/// Of the strongest potential in the hops where somebody speaks, against the nearest speaking source.
struct PotentialScore {
  std::optional<double> median_deg;
  std::optional<double> hits;  // share within kHitDegrees
};
[[nodiscard]] PotentialScore score_potentials(const KnownScene& scene, std::span<const HeardPotential> heard,
                                              Measure measure);

/// The middle value; of an even number the mean of the middle two. Empty for none.
[[nodiscard]] std::optional<double> median(std::vector<double> values);

}  // namespace odas
