// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/base/vec3.hpp"

namespace odas {

/// Two microphones, i < j.
struct Pair {
  std::size_t i, j;
};

/// All pairs, in ODAS's order: (0,1), (0,2), ..., (1,2), ...
[[nodiscard]] std::vector<Pair> all_pairs(std::size_t mics);

[[nodiscard]] Vec3 position(const MicConfig& mic) noexcept;

/// The largest distance between two microphones, m.
[[nodiscard]] float aperture(std::span<const MicConfig> mics) noexcept;

/// A flat array (all microphones within 1 mm of a plane, or on a line) cannot tell the two sides of its
/// plane apart. Returns the unit normal of the side that it listens to: that of the microphones' mean
/// direction, else +z, else (an upright plane) +x, then +y. Empty for an array with depth, and where all
/// microphones are in one place.
[[nodiscard]] std::optional<Vec3> flat_array_side(std::span<const MicConfig> mics) noexcept;

}  // namespace odas
