// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/types.hpp"
#include "odas/localization/search_plan.hpp"

namespace odas {

/// Moves a peak of the steered response off the grid, by all pairs jointly in both angles, and tells how
/// sharp it is.
///
/// Method: E(u) = mean over the pairs that hear u of x_q(lag_q(u)), lag_q(u) = -(rate r / c) (p_i - p_j) . u,
/// each correlation a parabola through the three lags around. Newton's method in the tangent plane (east,
/// north), Hessian sum x'' l_a l_b - delta_ab sum x' l(u), steps of at most 4 degrees, only uphill. A flat
/// array hears the two sides of its plane alike: the direction stays on the side it listens to.
class PeakFit {
 public:
  PeakFit(const GeneralConfig& general, const SearchPlan& plan, int interp_rate);

  struct Fit {
    Vec3 direction;
    float energy = 0;                      // E there
    float east = 0, north = 0, cross = 0;  // minus the second derivatives of E
  };
  /// `heard` [pair]: 1 where the pair hears the peak.
  [[nodiscard]] Fit fit(GridView<const float> correlations, std::span<const std::uint8_t> heard,
                        Vec3 start) const noexcept;
  /// The lag of a direction in a pair, in columns from lag 0.
  [[nodiscard]] float lag(std::size_t pair, Vec3 direction) const noexcept {
    return dot(baselines_[pair], direction);
  }

 private:
  struct Derivatives {
    float energy = 0, slope_east = 0, slope_north = 0;
    float east = 0, north = 0, cross = 0;  // second derivatives
  };
  [[nodiscard]] Derivatives at(GridView<const float> correlations, std::span<const std::uint8_t> heard,
                               Vec3 u) const noexcept;
  [[nodiscard]] Vec3 onto_side(Vec3 u) const noexcept;

  std::vector<Vec3> baselines_;  // [pair]: the gradient of its lag
  float half_lags_;
  std::optional<Vec3> side_;  // the normal of a flat array
};

/// The unit vectors of the tangent plane: where azimuth and elevation grow. At the poles: y and towards -x.
struct TangentPlane {
  explicit TangentPlane(Vec3 u) noexcept;
  Vec3 east, north;
};

}  // namespace odas
