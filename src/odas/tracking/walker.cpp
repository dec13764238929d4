// SPDX-License-Identifier: MIT
#include "odas/tracking/walker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odas {
namespace {

constexpr double square(double x) { return x * x; }

// Of people in rooms, 1 to 4 m away; chosen as docs/tracking.md says.
constexpr double kDrift2 = square(0.25 * kDegree);      // rad^2/s of one who stands: the head, the weight
constexpr double kTurning2 = square(16 * kDegree);      // (rad/s)^2 around the array, of one who walks
constexpr double kRising2 = square(3.8 * kDegree);      // (rad/s)^2 up and down
constexpr double kKeepsHeading = 12;                    // s
constexpr double kStands = 4.2, kWalks = 15;            // s, mean
constexpr double kOutlier = 0.1, kOutlierSpread = 3.4;  // share of outliers, and their variance
constexpr float kPolar = 0.94F;                         // sine of 70 degrees

}  // namespace

Walker::Walker(double hop_seconds) : dt_(hop_seconds), forget_(std::exp(-hop_seconds / kKeepsHeading)) {}

void Walker::start(Vec3 direction, const TangentCovariance& covariance) noexcept {
  direction_ = direction;
  for (Model& model : models_) {
    model = {0.5, {}, {}};
    model.east.pp = static_cast<double>(covariance.east);
    model.north.pp = static_cast<double>(covariance.north);
  }
  models_[1].east.vv = kTurning2;
  models_[1].north.vv = kRising2;
}

double Walker::Axis::observe(double z, double variance, double weight) noexcept {
  const double innovation = z - x;
  const double expected = pp + variance;
  const double log_likelihood = -0.5 * (std::log(expected) + innovation * innovation / expected);
  const double spread = pp + variance / weight;
  const double gain_p = pp / spread;
  const double gain_v = pv / spread;
  x += gain_p * innovation;
  v += gain_v * innovation;
  vv -= gain_v * pv;
  pv -= gain_p * pv;
  pp -= gain_p * pp;
  return weight * log_likelihood;
}

void Walker::Axis::walk(double dt, double forget, double speed2, bool goes_on) noexcept {
  if (goes_on) x += dt * v;
  pp += dt * (2 * pv + dt * vv);
  pv = forget * (pv + dt * vv);
  vv = forget * forget * vv + (1 - forget * forget) * speed2;
  v *= forget;
}

Walker::Axis Walker::joint(const Axis& a, double weight_a, const Axis& b, double weight_b) noexcept {
  Axis c;
  c.x = weight_a * a.x + weight_b * b.x;
  c.v = weight_a * a.v + weight_b * b.v;
  const double dx = a.x - b.x;
  const double dv = a.v - b.v;
  const double between = weight_a * weight_b;
  c.pp = weight_a * a.pp + weight_b * b.pp + between * dx * dx;
  c.pv = weight_a * a.pv + weight_b * b.pv + between * dx * dv;
  c.vv = weight_a * a.vv + weight_b * b.vv + between * dv * dv;
  return c;
}

/// `to_standing`: share of the standing one's new weight that comes of the walking one; and the other way.
void Walker::mix(Axis& standing, Axis& walking, double speed2, double to_standing,
                 double to_walking) noexcept {
  Axis starts = standing;  // of one who starts to walk nothing is known of where to
  starts.v = starts.pv = 0;
  starts.vv = speed2;
  Axis stops = walking;
  stops.v = stops.pv = stops.vv = 0;
  standing = joint(standing, 1 - to_standing, stops, to_standing);
  walking = joint(walking, 1 - to_walking, starts, to_walking);
}

void Walker::predict(bool goes_on) noexcept {
  auto& [stands, walks] = models_;
  const double starting = stands.weight * std::min(dt_ / kStands, 0.5);
  const double stopping = walks.weight * std::min(dt_ / kWalks, 0.5);
  stands.weight += stopping - starting;
  walks.weight += starting - stopping;
  mix(stands.east, walks.east, kTurning2, stopping / stands.weight, starting / walks.weight);
  mix(stands.north, walks.north, kRising2, stopping / stands.weight, starting / walks.weight);
  stands.east.pp += dt_ * kDrift2;
  stands.north.pp += dt_ * kDrift2;
  walks.east.walk(dt_, forget_, kTurning2, goes_on);
  walks.north.walk(dt_, forget_, kRising2, goes_on);
}

Walker::Offset Walker::offset_of(Vec3 z) const noexcept {
  const Vec3 u = direction_;
  const double level = std::hypot(static_cast<double>(u.x), static_cast<double>(u.y));
  if (std::max(std::abs(u.z), std::abs(z.z)) < kPolar) {
    // East by azimuth, not by the great circle: elevations may be far off and the azimuth right.
    const double cross = static_cast<double>(u.x) * static_cast<double>(z.y) -
                         static_cast<double>(u.y) * static_cast<double>(z.x);
    const double along = static_cast<double>(u.x) * static_cast<double>(z.x) +
                         static_cast<double>(u.y) * static_cast<double>(z.y);
    return {std::atan2(cross, along) * level,
            std::asin(static_cast<double>(z.z)) - std::asin(static_cast<double>(u.z))};
  }
  const double cosine = level > 0 ? static_cast<double>(u.x) / level : 1;
  const double sine = level > 0 ? static_cast<double>(u.y) / level : 0;
  const double dx = static_cast<double>(z.x - u.x);
  const double dy = static_cast<double>(z.y - u.y);
  const double dz = static_cast<double>(z.z - u.z);
  const double east = -sine * dx + cosine * dy;
  const double north = -static_cast<double>(u.z) * (cosine * dx + sine * dy) + level * dz;
  // As long as the arc is: the other end of the axis is not here.
  const double flat = std::hypot(east, north);
  const double arc = std::acos(std::clamp(static_cast<double>(dot(u, z)), -1.0, 1.0));
  if (!(flat > 1e-6)) return {0, dot(u, z) > 0 ? 0 : arc};
  return {east * arc / flat, north * arc / flat};
}

Walker::Fit Walker::fit(Offset offset, const TangentCovariance& noise) const noexcept {
  const TangentCovariance own = covariance();
  const double east = static_cast<double>(own.east) + static_cast<double>(noise.east);
  const double north = static_cast<double>(own.north) + static_cast<double>(noise.north);
  const double distance2 = square(offset.east) / east + square(offset.north) / north;
  const double scale = 1 / (2 * std::numbers::pi * std::sqrt(east * north));
  const double clean = (1 - kOutlier) * scale * std::exp(-0.5 * distance2);
  const double outlier = kOutlier * scale / kOutlierSpread * std::exp(-0.5 * distance2 / kOutlierSpread);
  const double density = clean + outlier;
  return {density, scale, density > 0 ? clean / density : 0};
}

void Walker::observe(Offset offset, const TangentCovariance& noise, double weight) noexcept {
  if (!(weight > 1e-4)) return;
  double log_weight[2];
  for (std::size_t m = 0; m < 2; ++m) {
    Model& model = models_[m];
    log_weight[m] = std::log(model.weight) +
                    model.east.observe(offset.east, static_cast<double>(noise.east), weight) +
                    model.north.observe(offset.north, static_cast<double>(noise.north), weight);
  }
  constexpr double kLeast = 0.0125;  // neither model is ever given up
  const double walks = 1 / (1 + std::exp(std::clamp(log_weight[0] - log_weight[1], -30.0, 30.0)));
  models_[1].weight = std::clamp(walks, kLeast, 1 - kLeast);
  models_[0].weight = 1 - models_[1].weight;
}

void Walker::settle() noexcept {
  const double east = models_[0].weight * models_[0].east.x + models_[1].weight * models_[1].east.x;
  const double north = models_[0].weight * models_[0].north.x + models_[1].weight * models_[1].north.x;
  const double level =
      std::max(std::hypot(static_cast<double>(direction_.x), static_cast<double>(direction_.y)), 0.0);
  const double cosine = level > 0 ? static_cast<double>(direction_.x) / level : 1;
  const double sine = level > 0 ? static_cast<double>(direction_.y) / level : 0;
  const double up = static_cast<double>(direction_.z);
  if (std::abs(direction_.z) < kPolar) {
    const double turn = east / level;
    const double elevation = std::asin(std::clamp(up, -1.0, 1.0)) + north;
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    direction_ = normalized({static_cast<float>(std::cos(elevation) * (cosine * c - sine * s)),
                             static_cast<float>(std::cos(elevation) * (sine * c + cosine * s)),
                             static_cast<float>(std::sin(elevation))});
  } else {
    direction_ =
        normalized({static_cast<float>(static_cast<double>(direction_.x) - sine * east - up * cosine * north),
                    static_cast<float>(static_cast<double>(direction_.y) + cosine * east - up * sine * north),
                    static_cast<float>(up + level * north)});
  }
  for (Model& model : models_) {
    model.east.x -= east;
    model.north.x -= north;
  }
}

TangentCovariance Walker::covariance() const noexcept {
  const auto& [stands, walks] = models_;
  const Axis east = joint(stands.east, stands.weight, walks.east, walks.weight);
  const Axis north = joint(stands.north, stands.weight, walks.north, walks.weight);
  return {static_cast<float>(east.pp), static_cast<float>(north.pp), 0};
}

}  // namespace odas
