// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// What a localizer made of its configuration.
struct LocalizerPlan {
  struct Scan {
    int level = 0;
    std::size_t points = 0;
    std::size_t active_points = 0;
  };
  std::size_t pairs = 0;
  std::size_t pairs_used = 0;
  std::vector<Scan> scans;
  std::size_t lags = 0;      // computed for each pair
  bool half_sphere = false;  // chosen because the array is flat
  double heard_share = 1;    // of the directions of the finest grid
  std::size_t memory_bytes = 0;
};

/// Finds the directions from which sound may come in one hop.
class Localizer {
 public:
  virtual ~Localizer() = default;

  /// spectra [mic][bin]; noise_psd [mic][bin], the power of the noise, empty unless needs_noise().
  /// Fills every element of `potentials`, those found first first. Allocates nothing.
  virtual void locate(GridView<const cfloat> spectra, GridView<const float> noise_psd,
                      std::span<Potential> potentials) noexcept = 0;
  [[nodiscard]] virtual bool needs_noise() const noexcept = 0;

  /// From now on the energy of every direction of the coarsest grid is kept. Allocates: before the first hop.
  virtual void keep_power_map() = 0;
  /// Of the last hop, before any potential was cut out: E of each direction of `power_grid`, 0 where nobody
  /// hears it. Empty unless it is kept.
  [[nodiscard]] virtual std::span<const float> power_map() const noexcept = 0;
  [[nodiscard]] virtual std::span<const Vec3> power_grid() const noexcept = 0;

  virtual void reset() noexcept = 0;
  [[nodiscard]] virtual LocalizerPlan plan() const = 0;
};

}  // namespace odas
