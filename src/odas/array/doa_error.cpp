// SPDX-License-Identifier: MIT
#include "odas/array/doa_error.hpp"

#include <algorithm>
#include <cmath>

namespace odas {
namespace {

constexpr double kRadian = 180 / 3.14159265358979323846;
constexpr double kLeastKnown = 1 / (1.57 * 1.57);  // 1/rad^2: a deviation of 90 degrees

double along(Vec3 d, Vec3 axis) noexcept { return static_cast<double>(dot(d, axis)); }

double angle_between_deg(Vec3 a, Vec3 b) noexcept {
  return static_cast<double>(degrees(std::atan2(norm(cross(a, b)), dot(a, b))));
}

}  // namespace

double DoaError::At::angle_deg() const noexcept {
  return std::min(90.0, std::hypot(azimuth_deg, elevation_deg));
}

double DoaError::Ambiguity::apart_deg() const noexcept { return angle_between_deg(a, b); }

DoaError::DoaError(const GeneralConfig& general, double tdoa_error_s)
    : pairs_(all_pairs(general.mics.size())),
      directivity_(general),
      gain_min_(general.gain_min),
      distance_error_(static_cast<double>(general.speedofsound.mu) * tdoa_error_s) {
  for (const MicConfig& mic : general.mics) positions_.push_back(position(mic));
}

std::vector<float> DoaError::gains(Vec3 direction) const {
  std::vector<float> all(positions_.size());
  for (std::size_t m = 0; m < all.size(); ++m) {
    all[m] = directivity_.mic(m, direction) * directivity_.filters(direction);
  }
  return all;
}

bool DoaError::hears(const Pair& pair, const std::vector<float>& gains) const noexcept {
  return gains[pair.i] * gains[pair.j] >= gain_min_;
}

std::optional<DoaError::At> DoaError::at(Vec3 direction) const {
  const float flat = std::hypot(direction.x, direction.y);
  const Vec3 east = flat > 1e-6F ? Vec3{-direction.y / flat, direction.x / flat, 0} : Vec3{0, 1, 0};
  const Vec3 north = cross(direction, east);
  const std::vector<float> gain = gains(direction);
  At result{direction, 0, 0, 0};
  double aa = kLeastKnown, ee = kLeastKnown, ae = 0;  // Fisher information in azimuth and elevation
  for (const Pair& pair : pairs_) {
    if (!hears(pair, gain)) continue;
    ++result.pairs;
    const Vec3 d = positions_[pair.i] - positions_[pair.j];
    const double a = along(d, east) / distance_error_, e = along(d, north) / distance_error_;
    aa += a * a;
    ee += e * e;
    ae += a * e;
  }
  if (result.pairs == 0) return std::nullopt;
  const double determinant = std::max(aa * ee - ae * ae, kLeastKnown * kLeastKnown);
  result.azimuth_deg = std::min(90.0, kRadian * std::sqrt(ee / determinant));
  result.elevation_deg = std::min(90.0, kRadian * std::sqrt(aa / determinant));
  return result;
}

std::vector<DoaError::Ambiguity> DoaError::ambiguities(std::span<const Vec3> directions, double least_deg,
                                                       std::size_t most) const {
  std::vector<std::vector<float>> gain;
  for (const Vec3& u : directions) gain.push_back(gains(u));
  const auto alike = [&](std::size_t a, std::size_t b) {
    const Vec3 difference = directions[a] - directions[b];
    bool common = false;
    for (const Pair& pair : pairs_) {
      if (!hears(pair, gain[a]) || !hears(pair, gain[b])) continue;
      common = true;
      if (std::abs(along(positions_[pair.i] - positions_[pair.j], difference)) > 2 * distance_error_)
        return false;
    }
    return common;
  };
  const auto cosine = static_cast<float>(std::cos(least_deg / kRadian));
  std::vector<Ambiguity> found;
  for (std::size_t a = 0; a < directions.size(); ++a) {
    for (std::size_t b = a + 1; b < directions.size(); ++b) {
      if (dot(directions[a], directions[b]) < cosine && alike(a, b))
        found.push_back({directions[a], directions[b]});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& x, const auto& y) { return x.apart_deg() > y.apart_deg(); });
  if (found.size() > most) found.resize(most);
  return found;
}

ArrayShape shape_of(std::span<const MicConfig> mics) noexcept {
  constexpr float kFlat = 1e-3F;  // m, as flat_array_side
  if (aperture(mics) <= kFlat) return ArrayShape::point;
  if (!flat_array_side(mics)) return ArrayShape::volume;
  const Vec3 origin = position(mics[0]);
  Vec3 axis;
  for (const MicConfig& mic : mics) {
    if (norm(position(mic) - origin) > norm(axis)) axis = position(mic) - origin;
  }
  axis = normalized(axis);
  for (const MicConfig& mic : mics) {
    if (norm(cross(position(mic) - origin, axis)) > kFlat) return ArrayShape::plane;
  }
  return ArrayShape::line;
}

}  // namespace odas
