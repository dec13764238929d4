// SPDX-License-Identifier: MIT
#include "odas/scene/ospa.hpp"

#include <algorithm>

#include "odas/scene/assignment.hpp"
#include "odas/scene/track_score.hpp"

namespace odas {
namespace {

bool near_any(const KnownScene& scene, std::size_t hop, const Direction& track, Measure measure,
              bool speaking) {
  return std::ranges::any_of(scene.sources, [&](const KnownSource& source) {
    return (source.active[hop] != 0) == speaking &&
           distance_deg(measure, track, source.direction[hop]) < kHitDegrees;
  });
}

/// Tracks that have to answer for themselves: not those that wait for a silent source to speak again.
std::vector<Direction> answerable(const KnownScene& scene, const HeardHop& heard, Measure measure) {
  std::vector<Direction> tracks;
  for (const HeardTrack& track : heard.tracks) {
    const bool waits = near_any(scene, heard.hop, track.direction, measure, false) &&
                       !near_any(scene, heard.hop, track.direction, measure, true);
    if (!waits) tracks.push_back(track.direction);
  }
  return tracks;
}

double ospa_of_hop(std::span<const Direction> tracks, std::span<const Direction> sources, Measure measure) {
  const std::size_t larger = std::max(tracks.size(), sources.size());
  if (larger == 0) return 0;
  Grid<double> cost(tracks.size(), sources.size());
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    for (std::size_t k = 0; k < sources.size(); ++k) {
      cost[t][k] = std::min(kOspaCutOff, distance_deg(measure, tracks[t], sources[k]));
    }
  }
  const auto partner = best_assignment(cost.view());
  double sum = kOspaCutOff * static_cast<double>(larger - std::min(tracks.size(), sources.size()));
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (partner[t]) sum += cost[t][*partner[t]];
  }
  return sum / static_cast<double>(larger);
}

}  // namespace

double ospa_deg(const KnownScene& scene, std::span<const HeardHop> heard, Measure measure) {
  std::vector<const HeardHop*> by_hop(scene.hops, nullptr);
  for (const HeardHop& hop : heard) {
    if (hop.hop < scene.hops) by_hop[hop.hop] = &hop;
  }
  double sum = 0;
  for (std::size_t h = 0; h < scene.hops; ++h) {
    std::vector<Direction> speaking, tracks;
    for (const KnownSource& source : scene.sources) {
      if (source.active[h] != 0) speaking.push_back(source.direction[h]);
    }
    if (by_hop[h] != nullptr) tracks = answerable(scene, *by_hop[h], measure);
    sum += ospa_of_hop(tracks, speaking, measure);
  }
  return scene.hops == 0 ? 0 : sum / static_cast<double>(scene.hops);
}

}  // namespace odas
