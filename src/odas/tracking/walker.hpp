// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "odas/array/types.hpp"
#include "odas/base/vec3.hpp"

namespace odas {

/// A source on the sphere that stands or walks, and how sure its place is.
///
/// Method: interacting multiple models (IMM) of two Kalman filters. The one that stands drifts a little; the
/// one that walks has a velocity that is forgotten exponentially (Ornstein-Uhlenbeck), so that it can neither
/// run away in a pause nor lose its heading at once. Both live in the tangent plane of the common estimate,
/// east and north apart: a flat array hears the one well and the other badly. An observation that belongs
/// here with probability b counts as b observations.
/// Symbols: offset x and velocity v of each axis, covariance (pp, pv, vv); w_m probability of a model.
/// Source: Blom and Bar-Shalom, 1988 (IMM); departs from it in that the innovation is weighed by its
/// information, not by the spread of several innovations.
/// Units: radians, seconds. Cost per hop: about 150 operations an observation.
/// Fails: over the very pole azimuth means nothing; there the tangent plane is drawn through the estimate
/// itself.
class Walker {
 public:
  explicit Walker(double hop_seconds);

  void start(Vec3 direction, const TangentCovariance& covariance) noexcept;
  /// `goes_on`: whether one who walks is thought to; who is long silent may have stopped anywhere.
  void predict(bool goes_on = true) noexcept;

  /// Where an observation lies as seen from here.
  struct Offset {
    double east = 0, north = 0;
  };
  [[nodiscard]] Offset offset_of(Vec3 direction) const noexcept;
  /// How often a hop that sounds deviates this far: the density (1/rad^2), with heavy tails.
  struct Fit {
    double density = 0;
    double peak = 1;   // of the density, where the offset is 0
    double clean = 0;  // probability that it is no outlier
  };
  [[nodiscard]] Fit fit(Offset offset, const TangentCovariance& noise) const noexcept;

  /// `weight`: as how many observations it counts. Nothing moves before `settle`.
  void observe(Offset offset, const TangentCovariance& noise, double weight) noexcept;
  /// After all observations of the hop: the common estimate.
  void settle() noexcept;

  [[nodiscard]] Vec3 direction() const noexcept { return direction_; }
  /// Variances of the estimate.
  [[nodiscard]] TangentCovariance covariance() const noexcept;
  /// Of walking rather than standing.
  [[nodiscard]] double walking() const noexcept { return models_[1].weight; }
  /// rad/s along east, as far as it walks.
  [[nodiscard]] double turning() const noexcept { return models_[1].weight * models_[1].east.v; }

 private:
  struct Axis {
    double x = 0, v = 0;
    double pp = 0, pv = 0, vv = 0;
    /// Returns the log of the likelihood.
    double observe(double z, double variance, double weight) noexcept;
    void walk(double dt, double forget, double speed2, bool goes_on) noexcept;
  };
  struct Model {
    double weight = 0;
    Axis east, north;
  };
  static void mix(Axis& standing, Axis& walking, double speed2, double to_standing,
                  double to_walking) noexcept;
  static Axis joint(const Axis& a, double weight_a, const Axis& b, double weight_b) noexcept;

  double dt_, forget_;
  Vec3 direction_{0, 0, 1};
  std::array<Model, 2> models_{};  // stands, walks
};

}  // namespace odas
