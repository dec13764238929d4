// SPDX-License-Identifier: MIT
#include "odas/scene/trajectory.hpp"

#include <algorithm>

namespace odas {

Waypoint waypoint_at(std::span<const Waypoint> path, double time) noexcept {
  const auto next =
      std::find_if(path.begin(), path.end(), [time](const Waypoint& w) { return w.time > time; });
  if (next == path.begin()) return path.front();
  if (next == path.end()) return path.back();
  const Waypoint& a = *std::prev(next);
  const Waypoint& b = *next;
  const auto share = static_cast<float>((time - a.time) / (b.time - a.time));
  return {time, a.azimuth + share * (b.azimuth - a.azimuth),
          a.elevation + share * (b.elevation - a.elevation), a.distance + share * (b.distance - a.distance)};
}

Vec3 direction_at(std::span<const Waypoint> path, double time) noexcept {
  const Waypoint w = waypoint_at(path, time);
  return direction_of(w.azimuth, w.elevation);
}

Vec3 position_at(std::span<const Waypoint> path, double time) noexcept {
  const Waypoint w = waypoint_at(path, time);
  return w.distance * direction_of(w.azimuth, w.elevation);
}

bool is_at_rest(std::span<const Waypoint> path) noexcept {
  return std::all_of(path.begin(), path.end(), [&](const Waypoint& w) {
    return w.azimuth == path[0].azimuth && w.elevation == path[0].elevation && w.distance == path[0].distance;
  });
}

}  // namespace odas
