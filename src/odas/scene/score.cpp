// SPDX-License-Identifier: MIT
#include "odas/scene/score.hpp"

#include "odas/scene/ospa.hpp"

namespace odas {
namespace {

PlaceScore place_score(const KnownScene& scene, const Audition& audition, Measure measure) {
  PlaceScore result;
  if (audition.potentials) result.potentials = score_potentials(scene, *audition.potentials, measure);
  result.tracks = score_tracks(scene, audition.tracks, measure);
  result.ospa_deg = ospa_deg(scene, audition.tracks, measure);
  return result;
}

}  // namespace

Score score(const KnownScene& scene, const std::optional<KnownSound>& sound, const Audition& audition) {
  Score result;
  result.seconds = static_cast<double>(scene.hops) * scene.hop_seconds();
  result.sources = scene.sources.size();
  result.angle = place_score(scene, audition, Measure::angle);
  result.azimuth = place_score(scene, audition, Measure::azimuth);
  if (!sound) return result;
  const auto& followed = result.azimuth.tracks.followed;
  if (audition.separated) result.separated = score_separation(scene, *sound, followed, audition.separated);
  if (audition.postfiltered) {
    result.postfiltered = score_separation(scene, *sound, followed, audition.postfiltered);
  }
  return result;
}

}  // namespace odas
