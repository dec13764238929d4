// SPDX-License-Identifier: MIT
#include "odas/io/report_history.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace odas {
namespace {

constexpr double kTrailPointsPerSecond = 25;
constexpr double kPotentialHopsPerSecond = 32;
constexpr std::size_t kMaxTrailPoints = 40'000;
constexpr std::size_t kMaxPotentials = 20'000;
constexpr float kMovedDegrees = 10;

HopIndex stride(double hop_seconds, double per_second) {
  return static_cast<HopIndex>(std::max(1.0, std::round(1 / (hop_seconds * per_second))));
}

bool nonzero(Vec3 v) { return norm(v) > 0; }

/// The azimuth of the sum, the elevation of the mean height: a walk around the array must not lift the
/// elevation.
Vec3 mean_direction(Vec3 sum, std::uint64_t count) {
  const float z = std::clamp(sum.z / static_cast<float>(count), -1.F, 1.F);
  return direction_of(azimuth_deg(sum), degrees(std::asin(z)));
}

}  // namespace

ReportHistory::ReportHistory(std::size_t hop_size, int sample_rate)
    : hop_seconds_(static_cast<double>(hop_size) / sample_rate),
      seen_(stride(hop_seconds_, kTrailPointsPerSecond), kMaxTrailPoints),
      potentials_(stride(hop_seconds_, kPotentialHopsPerSecond), kMaxPotentials) {}

double ReportHistory::seconds(HopIndex time) const noexcept {
  return static_cast<double>(time - 1) * hop_seconds_;
}

void ReportHistory::add(HopIndex time, std::span<const Potential> potentials, std::span<const Track> tracks) {
  for (const Potential& p : potentials) {
    if (p.energy > 0) potentials_.add(time, p);
  }
  for (const Track& track : tracks) {
    if (track.id != 0) follow(time, track);
  }
}

void ReportHistory::follow(HopIndex time, const Track& track) {
  Life& life = lives_[track.id];
  const TrailPoint point{seconds(time), track.direction, track.activity};
  if (life.born == 0) {
    life.born = time;
    life.birth = point;
  }
  life.tag = track.tag.view();
  life.seen = time;
  life.death = point;
  ++life.hops;
  life.sum = life.sum + track.direction;
  if (track.activity >= 0.5F) {
    ++life.active_hops;
    life.active_sum = life.active_sum + track.direction;
    const auto half_second = static_cast<std::size_t>((point.seconds - life.birth.seconds) * 2);
    if (life.half_seconds.size() <= half_second) life.half_seconds.resize(half_second + 1);
    life.half_seconds[half_second] = life.half_seconds[half_second] + track.direction;
  }
  seen_.add(time, {track.id, track.direction, track.activity});
}

std::vector<SourceHistory> ReportHistory::sources() const {
  std::vector<SourceHistory> result;
  std::map<std::uint64_t, std::size_t> index;
  for (const auto& [id, life] : lives_) {
    index[id] = result.size();
    SourceHistory s;
    s.id = id;
    s.tag = life.tag;
    s.from_s = seconds(life.born);
    s.to_s = seconds(life.seen) + hop_seconds_;
    s.active_share = static_cast<double>(life.active_hops) / static_cast<double>(life.hops);
    s.mean = life.active_hops > 0 ? mean_direction(life.active_sum, life.active_hops)
                                  : mean_direction(life.sum, life.hops);
    const auto first = std::find_if(life.half_seconds.begin(), life.half_seconds.end(), nonzero);
    const auto last = std::find_if(life.half_seconds.rbegin(), life.half_seconds.rend(), nonzero);
    s.first = first == life.half_seconds.end() ? life.birth.direction : normalized(*first);
    s.last = last == life.half_seconds.rend() ? life.death.direction : normalized(*last);
    s.trail.push_back(life.birth);
    result.push_back(std::move(s));
  }
  for (const auto& [time, seen] : seen_.entries()) {
    const Life& life = lives_.at(seen.id);
    if (time == life.born || time == life.seen) continue;
    result[index[seen.id]].trail.push_back({seconds(time), seen.direction, seen.activity});
  }
  for (SourceHistory& s : result) {
    const Life& life = lives_.at(s.id);
    if (life.seen != life.born) s.trail.push_back(life.death);
  }
  return result;
}

std::vector<PotentialPoint> ReportHistory::potentials() const {
  std::vector<PotentialPoint> result;
  result.reserve(potentials_.entries().size());
  for (const auto& [time, p] : potentials_.entries())
    result.push_back({seconds(time), p.direction, p.energy});
  return result;
}

std::string table_of(std::span<const SourceHistory> sources, std::string (*file_of)(std::uint64_t id)) {
  if (sources.empty()) return "No source was followed.\n";
  const auto angle = [](const SourceHistory& s, float (*of)(Vec3)) {
    const float change = std::abs(of(s.first) - of(s.last));
    return std::min(change, 360 - change) >= kMovedDegrees
               ? fmt::format("{:.0f} -> {:.0f}", of(s.first), of(s.last))
               : fmt::format("{:.0f}", of(s.mean));
  };
  std::string text = fmt::format("{:>6}  {:>8}  {:>8}  {:>13}  {:>13}  {:>6}  {}\n", "source", "from, s",
                                 "to, s", "azimuth, deg", "elevation", "active", "voice");
  for (const SourceHistory& s : sources) {
    text += fmt::format("{:>6}  {:>8.1f}  {:>8.1f}  {:>13}  {:>13}  {:>5.0f}%  {}\n", s.id, s.from_s, s.to_s,
                        angle(s, azimuth_deg), angle(s, elevation_deg), 100 * s.active_share, file_of(s.id));
  }
  return text;
}

}  // namespace odas
