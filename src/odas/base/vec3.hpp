// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace odas {

/// A point in metres or a direction, in the right-handed frame of the array.
struct Vec3 {
  float x = 0, y = 0, z = 0;

  friend Vec3 operator+(Vec3 a, Vec3 b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(float s, Vec3 a) noexcept { return {s * a.x, s * a.y, s * a.z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

[[nodiscard]] inline float dot(Vec3 a, Vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline float norm(Vec3 a) noexcept { return std::sqrt(dot(a, a)); }
[[nodiscard]] inline Vec3 cross(Vec3 a, Vec3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The unit vector along `a`; `a` itself when it has no length.
[[nodiscard]] inline Vec3 normalized(Vec3 a) noexcept {
  const float n = norm(a);
  return n > 0 ? (1 / n) * a : a;
}

inline constexpr float kPi = 3.14159265358979323846F;
inline constexpr double kDegree = 3.14159265358979323846 / 180;  // in radians
[[nodiscard]] constexpr float degrees(float radians) noexcept { return radians * (180 / kPi); }
[[nodiscard]] constexpr float radians(float degrees) noexcept { return degrees * (kPi / 180); }

/// Azimuth in degrees, from x towards y, in (-180, 180].
[[nodiscard]] inline float azimuth_deg(Vec3 u) noexcept { return degrees(std::atan2(u.y, u.x)); }
/// Elevation in degrees over the xy plane, in [-90, 90].
[[nodiscard]] inline float elevation_deg(Vec3 u) noexcept {
  return degrees(std::atan2(u.z, std::hypot(u.x, u.y)));
}
/// The unit vector of an azimuth and an elevation in degrees.
[[nodiscard]] inline Vec3 direction_of(float azimuth, float elevation) noexcept {
  const float a = radians(azimuth);
  const float e = radians(elevation);
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

}  // namespace odas
