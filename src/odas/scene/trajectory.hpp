// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/scene/scene.hpp"

namespace odas {

/// Where a source is at `time` seconds: straight between waypoints in azimuth, elevation and distance, and
/// at rest before the first and after the last. `path` is not empty.
[[nodiscard]] Waypoint waypoint_at(std::span<const Waypoint> path, double time) noexcept;

/// Unit vector from the middle of the array to the source.
[[nodiscard]] Vec3 direction_at(std::span<const Waypoint> path, double time) noexcept;

/// From the middle of the array to the source, m.
[[nodiscard]] Vec3 position_at(std::span<const Waypoint> path, double time) noexcept;

/// True where all waypoints are at the same place.
[[nodiscard]] bool is_at_rest(std::span<const Waypoint> path) noexcept;

}  // namespace odas
