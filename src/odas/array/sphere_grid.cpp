// SPDX-License-Identifier: MIT
#include "odas/array/sphere_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

using Triangle = std::array<std::size_t, 3>;

/// Halves edges, each only once: the neighbour triangle finds the midpoint that the first one made.
template <class MakeMidpoint>
std::vector<Triangle> subdivided(const std::vector<Triangle>& triangles, MakeMidpoint make) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
  const auto midpoint = [&](std::size_t a, std::size_t b) {
    const auto key = std::minmax(a, b);
    const auto [it, is_new] = known.try_emplace({key.first, key.second}, 0);
    if (is_new) it->second = make(a, b);
    return it->second;
  };
  std::vector<Triangle> children;
  children.reserve(4 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const std::size_t m1 = midpoint(a, b);
    const std::size_t m2 = midpoint(b, c);
    const std::size_t m3 = midpoint(c, a);
    children.insert(children.end(), {{a, m1, m3}, {m1, b, m2}, {m1, m2, m3}, {m3, m2, c}});
  }
  return children;
}

/// Numbers the vertices as a walk over the triangles meets them, in the triangles too: ODAS's order.
std::vector<std::size_t> renumber(std::vector<Triangle>& triangles, std::size_t vertices) {
  constexpr std::size_t kUnmet = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> number(vertices, kUnmet);
  std::size_t met = 0;
  for (auto& triangle : triangles) {
    for (std::size_t& vertex : triangle) {
      if (number[vertex] == kUnmet) number[vertex] = met++;
      vertex = number[vertex];
    }
  }
  return number;
}

float squared_distance(Vec3 a, Vec3 b) noexcept {
  const Vec3 d = a - b;
  return dot(d, d);
}

Vec3 to_unit(Vec3 a) noexcept {
  const float n = norm(a);
  return {a.x / n, a.y / n, a.z / n};
}

std::vector<Vec3> icosahedron() {
  const float h = std::sqrt(5.F) / 5;
  const float r = (2.F / 5.F) * std::sqrt(5.F);  // not 2 h: the last bit decides ties
  std::vector<Vec3> points(12);
  points[0] = {0, 0, 1};
  for (std::size_t i = 0; i < 5; ++i) {
    const auto a = static_cast<float>(2 * std::numbers::pi * static_cast<double>(i) / 5);
    const float s = std::sin(a);
    const float c = std::cos(a);
    points[1 + i] = {r * s, r * c, h};
    points[6 + i] = {-r * s, -r * c, -h};
  }
  points[11] = {0, 0, -1};
  return points;
}

const std::vector<Triangle> kIcosahedronFaces{{0, 2, 1},  {0, 3, 2},  {0, 4, 3},  {0, 5, 4},   {0, 1, 5},
                                              {9, 1, 2},  {10, 2, 3}, {6, 3, 4},  {7, 4, 5},   {8, 5, 1},
                                              {4, 7, 6},  {5, 8, 7},  {1, 9, 8},  {2, 10, 9},  {3, 6, 10},
                                              {11, 6, 7}, {11, 7, 8}, {11, 8, 9}, {11, 9, 10}, {11, 10, 6}};

/// For each point, the nearest other one. Only points that share an edge can be it.
std::vector<std::size_t> nearest_neighbours(const std::vector<Vec3>& points,
                                            const std::vector<Triangle>& triangles) {
  std::vector<std::size_t> nearest(points.size());
  std::vector<float> distance(points.size(), std::numeric_limits<float>::infinity());
  const auto offer = [&](std::size_t to, std::size_t candidate) {
    const float d = squared_distance(points[to], points[candidate]);
    if (d < distance[to] || (d == distance[to] && candidate < nearest[to])) {
      distance[to] = d;
      nearest[to] = candidate;
    }
  };
  for (const auto& t : triangles) {
    for (std::size_t e = 0; e < 3; ++e) {
      offer(t[e], t[(e + 1) % 3]);
      offer(t[(e + 1) % 3], t[e]);
    }
  }
  return nearest;
}

}  // namespace

SphereGrid::SphereGrid(int level) : level_(level) {
  ODAS_EXPECT(level >= 0 && level <= 7);
  std::vector<Vec3> vertices = icosahedron();
  std::vector<Triangle> triangles = kIcosahedronFaces;
  for (int l = 0; l < level; ++l) {
    triangles = subdivided(triangles, [&](std::size_t a, std::size_t b) {
      vertices.push_back(to_unit(vertices[a] + vertices[b]));
      return vertices.size() - 1;
    });
  }
  const std::vector<std::size_t> number = renumber(triangles, vertices.size());
  points_.resize(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) points_[number[v]] = vertices[v];
  nearest_ = nearest_neighbours(points_, triangles);
}

SpherePatch::SpherePatch(int refined_levels) {
  std::vector<Triangle> triangles;
  for (std::size_t k = 0; k < 8; ++k) triangles.push_back({1 + k, 0, 1 + (k + 1) % 8});
  for (int l = 0; l < refined_levels; ++l) {
    triangles = subdivided(triangles, [this](std::size_t a, std::size_t b) {
      midpoints_.push_back({a, b});
      return 8 + midpoints_.size();
    });
  }
  number_ = renumber(triangles, 9 + midpoints_.size());
}

void SpherePatch::place(Vec3 centre, Vec3 towards, std::span<Vec3> out) const noexcept {
  ODAS_EXPECT(out.size() == size());
  const Vec3 corner = centre + towards - dot(centre, towards) * centre;
  out[number_[0]] = centre;
  for (std::size_t k = 0; k < 8; ++k) {  // Rodrigues' rotation of the first corner about the centre
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 8;
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    out[number_[1 + k]] =
        to_unit(c * corner + s * cross(centre, corner) + ((1 - c) * dot(centre, corner)) * centre);
  }
  for (std::size_t m = 0; m < midpoints_.size(); ++m) {
    const auto [a, b] = midpoints_[m];
    out[number_[9 + m]] = to_unit(out[number_[a]] + out[number_[b]]);
  }
}

}  // namespace odas
