// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/array/types.hpp"
#include "odas/tracking/target.hpp"

namespace odas {

/// Directions in which nobody is heard: a loudspeaker of the robot itself, a window to the street.
///
/// A potential in such a direction has the energy 0, so that no track is born of it; a track that is there,
/// or comes there, leaves its slot empty for as long. Targets are heard everywhere: they were asked for.
class Muting {
 public:
  /// How far around a muted direction it is quiet. About the error of a small array in a room.
  static constexpr float kRadius = 15;  // degrees

  void set(std::span<const Target> directions) noexcept { directions_.assign(directions); }
  void hush(std::span<Potential> potentials) const noexcept;
  void hush(std::span<Track> tracks) const noexcept;

 private:
  [[nodiscard]] bool holds(Vec3 direction) const noexcept;
  TargetList directions_;
};

}  // namespace odas
