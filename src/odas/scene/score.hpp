// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/scene/audition.hpp"
#include "odas/scene/track_score.hpp"

namespace odas {

/// The figures of one measure of distance.
struct PlaceScore {
  PotentialScore potentials;
  TrackScore tracks;
  double ospa_deg = 0;
};

/// How well a system heard a scene.
struct Score {
  double seconds = 0;
  std::size_t sources = 0;
  PlaceScore angle, azimuth;
  std::optional<SeparationScore> separated, postfiltered;
};

/// `sound` may be empty: then the voices are not scored. A voice is that of the track which is paired with
/// the source by azimuth.
[[nodiscard]] Score score(const KnownScene& scene, const std::optional<KnownSound>& sound,
                          const Audition& audition);

}  // namespace odas
