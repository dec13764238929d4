// SPDX-License-Identifier: MIT
#include "odas/scene/truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odas {

double distance_deg(Measure measure, const Direction& a, const Direction& b) noexcept {
  constexpr double kDegrees = 180 / std::numbers::pi;
  if (measure == Measure::angle) {
    return kDegrees * std::acos(std::clamp(a.x * b.x + a.y * b.y + a.z * b.z, -1.0, 1.0));
  }
  const double difference = std::atan2(a.y, a.x) - std::atan2(b.y, b.x);
  return kDegrees * std::abs(std::remainder(difference, 2 * std::numbers::pi));
}

}  // namespace odas
