// SPDX-License-Identifier: MIT
#include "odas/array/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace odas {
namespace {

constexpr float kFlat = 1e-3F;  // m

/// The microphone farthest from the line through `origin` along unit vector `axis`, as a vector off it.
Vec3 farthest_off_line(std::span<const MicConfig> mics, Vec3 origin, Vec3 axis) noexcept {
  Vec3 best;
  for (const MicConfig& mic : mics) {
    const Vec3 d = position(mic) - origin;
    const Vec3 off = d - dot(d, axis) * axis;
    if (norm(off) > norm(best)) best = off;
  }
  return best;
}

/// Where the microphones look on average; +z when they look everywhere.
Vec3 mean_direction(std::span<const MicConfig> mics) noexcept {
  Vec3 sum;
  for (const MicConfig& mic : mics) {
    sum = sum + normalized({mic.direction[0], mic.direction[1], mic.direction[2]});
  }
  return norm(sum) > 1e-3F * static_cast<float>(mics.size()) ? normalized(sum) : Vec3{0, 0, 1};
}

}  // namespace

std::vector<Pair> all_pairs(std::size_t mics) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < mics; ++i) {
    for (std::size_t j = i + 1; j < mics; ++j) pairs.push_back({i, j});
  }
  return pairs;
}

Vec3 position(const MicConfig& mic) noexcept { return {mic.mu[0], mic.mu[1], mic.mu[2]}; }

float aperture(std::span<const MicConfig> mics) noexcept {
  float largest = 0;
  for (std::size_t i = 0; i < mics.size(); ++i) {
    for (std::size_t j = i + 1; j < mics.size(); ++j) {
      largest = std::max(largest, norm(position(mics[i]) - position(mics[j])));
    }
  }
  return largest;
}

std::optional<Vec3> flat_array_side(std::span<const MicConfig> mics) noexcept {
  if (mics.size() < 2) return std::nullopt;
  const Vec3 origin = position(mics[0]);
  Vec3 first;  // the longest way from the first microphone: one axis of the plane
  for (const MicConfig& mic : mics) {
    if (norm(position(mic) - origin) > norm(first)) first = position(mic) - origin;
  }
  if (norm(first) <= kFlat) return std::nullopt;  // all in one place: no plane
  first = normalized(first);
  const Vec3 side = mean_direction(mics);
  const Vec3 off = farthest_off_line(mics, origin, first);
  if (norm(off) <= kFlat) {  // a line lies in many planes: take the one that faces the side best
    const Vec3 facing = side - dot(side, first) * first;
    if (norm(facing) > 0.1F) return normalized(facing);
    const Vec3 other = Vec3{0, 0, 1} - first.z * first;
    return norm(other) > 0.1F ? normalized(other) : Vec3{1, 0, 0};
  }
  const Vec3 normal = normalized(cross(first, normalized(off)));
  for (const MicConfig& mic : mics) {
    if (std::abs(dot(position(mic) - origin, normal)) > kFlat) return std::nullopt;
  }
  const float facing = dot(normal, side);
  if (std::abs(facing) > 0.1F) return facing > 0 ? normal : -1 * normal;
  if (std::abs(normal.z) > 0.1F) return normal.z > 0 ? normal : -1 * normal;
  // An upright plane whose microphones look along it: no side is better; take the one towards +x, then +y.
  return normal.x + 1e-3F * normal.y > 0 ? normal : -1 * normal;
}

}  // namespace odas
