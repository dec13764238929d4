// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/directivity.hpp"
#include "odas/array/geometry.hpp"
#include "odas/array/sphere_grid.hpp"
#include "odas/base/grid.hpp"

namespace odas {

/// One sphere grid as an array hears it: which pairs of microphones hear which direction, and at which lag.
///
/// lag(u, q) = round(-(rate r / c) (p_i - p_j) . u), in samples interpolated r times: the lag at which the
/// cross-correlation of x_i and x_j peaks for a plane wave from u.
/// mask(u, q) = 1 where G_i(u) G_j(u) >= gain_min, G being the microphone's gain times the spatial filters'.
class ScanLevel {
 public:
  ScanLevel(const GeneralConfig& config, const Directivity& directivity, std::span<const Pair> pairs,
            int level, int interp_rate);

  [[nodiscard]] const SphereGrid& grid() const noexcept { return grid_; }
  [[nodiscard]] std::size_t pairs() const noexcept { return lags_.cols(); }
  [[nodiscard]] std::span<const std::int16_t> lags(std::size_t point) const noexcept { return lags_[point]; }
  [[nodiscard]] std::span<const std::uint8_t> mask(std::size_t point) const noexcept { return mask_[point]; }
  /// How many pairs hear the point.
  [[nodiscard]] int active_pairs(std::size_t point) const noexcept { return active_pairs_[point]; }
  /// The points that at least one pair hears, rising.
  [[nodiscard]] const std::vector<std::size_t>& active_points() const noexcept { return active_points_; }
  /// Over all points of the grid.
  [[nodiscard]] int min_lag(std::size_t pair) const noexcept { return min_lag_[pair]; }
  [[nodiscard]] int max_lag(std::size_t pair) const noexcept { return max_lag_[pair]; }

 private:
  SphereGrid grid_;
  Grid<std::int16_t> lags_;  // [point][pair]
  Grid<std::uint8_t> mask_;  // [point][pair]
  std::vector<int> active_pairs_;
  std::vector<std::size_t> active_points_;
  std::vector<int> min_lag_, max_lag_;
};

}  // namespace odas
