// SPDX-License-Identifier: MIT
#include "odas/scene/track_score.hpp"

#include <algorithm>
#include <numeric>

#include "odas/scene/assignment.hpp"

namespace odas {
namespace {

constexpr double kNoPair = 1000;  // degrees: dearer than any number of hits

class Scorer {
 public:
  Scorer(const KnownScene& scene, Measure measure)
      : scene_(scene),
        measure_(measure),
        followed_(scene.sources.size(), std::vector<HeardTrack>(scene.hops)),
        ids_(scene.sources.size()),
        ids_apart_(scene.sources.size()) {}

  void add(const HeardHop& heard) {
    const std::size_t sources = scene_.sources.size();
    const std::size_t tracks = heard.tracks.size();
    Grid<double> distance(tracks, sources);
    Grid<double> cost(tracks, sources);
    for (std::size_t t = 0; t < tracks; ++t) {
      for (std::size_t k = 0; k < sources; ++k) {
        distance[t][k] =
            distance_deg(measure_, heard.tracks[t].direction, scene_.sources[k].direction[heard.hop]);
        cost[t][k] = distance[t][k] < kHitDegrees ? distance[t][k] : kNoPair;
      }
    }
    const auto partner = best_assignment(cost.view());
    for (std::size_t t = 0; t < tracks; ++t) {
      if (partner[t] && distance[t][*partner[t]] < kHitDegrees) {
        hit(heard.hop, heard.tracks[t], *partner[t], distance[t][*partner[t]]);
      } else if (std::ranges::any_of(distance[t], [](double d) { return d < kHitDegrees; })) {
        ++duplicates_;
      } else {
        ++false_;
      }
    }
  }

  [[nodiscard]] TrackScore result() {
    TrackScore score;
    score.false_s_per_min = static_cast<double>(false_) * scene_.hop_seconds() / scene_.minutes();
    score.followed = std::move(followed_);
    if (scene_.sources.empty()) return score;
    const auto sources = static_cast<double>(scene_.sources.size());
    score.duplicates = static_cast<double>(duplicates_) / static_cast<double>(scene_.hops);
    score.switches_per_min = static_cast<double>(changes(ids_)) / scene_.minutes() / sources;
    score.switches_apart_per_min = static_cast<double>(changes(ids_apart_)) / scene_.minutes() / sources;
    if (!errors_.empty()) {
      score.error_deg =
          std::accumulate(errors_.begin(), errors_.end(), 0.0) / static_cast<double>(errors_.size());
    }
    add_times(score);
    return score;
  }

 private:
  using Ids = std::vector<std::vector<std::uint64_t>>;  // [source]: in order, while it speaks

  static void follow(std::vector<std::uint64_t>& ids, std::uint64_t id) {
    if (ids.empty() || ids.back() != id) ids.push_back(id);
  }
  static std::size_t changes(const Ids& all) {
    std::size_t sum = 0;
    for (const auto& ids : all) sum += ids.empty() ? 0 : ids.size() - 1;
    return sum;
  }

  [[nodiscard]] bool is_apart(std::size_t source, std::size_t hop) const {
    for (std::size_t k = 0; k < scene_.sources.size(); ++k) {
      const double apart =
          distance_deg(measure_, scene_.sources[k].direction[hop], scene_.sources[source].direction[hop]);
      if (k != source && apart < kApartDegrees) return false;
    }
    return true;
  }

  void hit(std::size_t hop, const HeardTrack& track, std::size_t source, double distance) {
    followed_[source][hop] = track;
    if (scene_.sources[source].active[hop] == 0) return;
    errors_.push_back(distance);
    follow(ids_[source], track.id);
    if (is_apart(source, hop)) follow(ids_apart_[source], track.id);
  }

  void add_times(TrackScore& score) const {
    std::size_t speaking = 0;
    std::size_t hits = 0;
    std::vector<double> onsets;
    for (std::size_t k = 0; k < scene_.sources.size(); ++k) {
      std::optional<std::size_t> first_word, first_hit;
      for (std::size_t h = 0; h < scene_.hops; ++h) {
        if (scene_.sources[k].active[h] == 0) continue;
        ++speaking;
        if (!first_word) first_word = h;
        if (score.followed[k][h].id == 0) continue;
        ++hits;
        if (!first_hit) first_hit = h;
      }
      if (!first_word) continue;
      onsets.push_back(first_hit ? static_cast<double>(*first_hit - *first_word) * scene_.hop_seconds()
                                 : kNeverSeconds);
    }
    if (speaking > 0) score.recall = static_cast<double>(hits) / static_cast<double>(speaking);
    score.onset_s = median(std::move(onsets));
  }

  const KnownScene& scene_;
  Measure measure_;
  std::vector<std::vector<HeardTrack>> followed_;
  Ids ids_, ids_apart_;
  std::vector<double> errors_;
  std::size_t duplicates_ = 0;
  std::size_t false_ = 0;
};

}  // namespace

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

TrackScore score_tracks(const KnownScene& scene, std::span<const HeardHop> heard, Measure measure) {
  Scorer scorer(scene, measure);
  for (const HeardHop& hop : heard) {
    if (hop.hop < scene.hops) scorer.add(hop);
  }
  return scorer.result();
}

PotentialScore score_potentials(const KnownScene& scene, std::span<const HeardPotential> heard,
                                Measure measure) {
  std::vector<double> nearest;
  for (const HeardPotential& potential : heard) {
    if (potential.hop >= scene.hops) continue;
    std::optional<double> distance;
    for (const KnownSource& source : scene.sources) {
      if (source.active[potential.hop] == 0) continue;
      const double d = distance_deg(measure, potential.direction, source.direction[potential.hop]);
      distance = std::min(d, distance.value_or(d));
    }
    if (distance) nearest.push_back(*distance);
  }
  PotentialScore score;
  if (nearest.empty()) return score;
  const auto hits = std::ranges::count_if(nearest, [](double d) { return d < kHitDegrees; });
  score.hits = static_cast<double>(hits) / static_cast<double>(nearest.size());
  score.median_deg = median(std::move(nearest));
  return score;
}

}  // namespace odas
