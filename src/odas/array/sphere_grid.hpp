// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/base/vec3.hpp"

namespace odas {

/// Directions spread evenly over the sphere: an icosahedron whose edges were halved `level` times.
/// 10 * 4^level + 2 points; the first is the north pole. Points and their order are ODAS's, computed in
/// float as ODAS does, so that trained deltas and ties come out alike.
class SphereGrid {
 public:
  explicit SphereGrid(int level);

  [[nodiscard]] int level() const noexcept { return level_; }
  [[nodiscard]] std::size_t size() const noexcept { return points_.size(); }
  [[nodiscard]] std::span<const Vec3> points() const noexcept { return points_; }
  /// The nearest other point; of equally near ones the first.
  [[nodiscard]] std::size_t nearest(std::size_t point) const noexcept { return nearest_[point]; }

 private:
  int level_;
  std::vector<Vec3> points_;
  std::vector<std::size_t> nearest_;
};

/// A small patch of the sphere around a point: an octagon of eight triangles, each halved `refined_levels`
/// times; 4 (2^n + 4^n) + 1 directions. The same mesh serves every point.
class SpherePatch {
 public:
  explicit SpherePatch(int refined_levels);

  [[nodiscard]] std::size_t size() const noexcept { return number_.size(); }
  /// The directions around `centre`, whose octagon's first corner lies towards `towards`. In the order in
  /// which a walk over the triangles meets them.
  void place(Vec3 centre, Vec3 towards, std::span<Vec3> out) const noexcept;

 private:
  struct Edge {
    std::size_t a, b;
  };
  std::vector<Edge> midpoints_;      // of vertices: 0 the centre, 1..8 the octagon, 9.. the midpoints so far
  std::vector<std::size_t> number_;  // [vertex]: where it stands in the order
};

}  // namespace odas
