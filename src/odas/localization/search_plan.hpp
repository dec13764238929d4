// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/geometry.hpp"
#include "odas/base/grid.hpp"
#include "odas/localization/config.hpp"
#include "odas/localization/localizer.hpp"

namespace odas {

/// All that SRP-PHAT-HSDA can work out before the first sound: the grids as the array hears them, the width
/// of each pair's sliding maximum, and for each winner of a coarse level the candidates of the next, with
/// the columns of the correlation rows that each candidate reads.
/// Errors: throws ConfigError where no direction is heard by any pair.
struct SearchPlan {
  SearchPlan(const GeneralConfig& general, const SslConfig& ssl);

  /// Directions that are searched together.
  struct Cell {
    std::vector<std::uint32_t> points;  // of the level's grid, rising
    std::vector<float> pairs;           // [candidate]: how many pairs hear it
    Grid<std::uint16_t> columns;        // [pair][candidate, padded]: what to read of the pair's row
  };
  struct Level {
    int number = 0;                // `ssl.scans[i].level`
    std::vector<Vec3> directions;  // of the whole grid
    std::size_t active_points = 0;
    std::vector<std::size_t> deltas;       // [pair]: half-width of the sliding maximum
    std::vector<std::size_t> first, last;  // [pair]: the columns that the level reads
    std::vector<Cell> cells;               // one for the first level, else one per point of the level above
  };

  std::vector<Pair> pairs;        // those that hear at least one direction
  std::vector<Level> levels;      // coarse to fine
  Grid<std::int16_t> fine_lags;   // [point of the finest grid][pair]
  Grid<std::uint8_t> fine_heard;  // [point of the finest grid][pair]: 1 where the pair hears it
  std::size_t half_lags = 0;      // lags -half_lags .. half_lags are computed
  std::size_t row_size = 0;       // columns of a correlation row
  LocalizerPlan summary;

  /// Column of lag 0 is `half_lags`; this one is always zero, for pairs that do not hear a candidate.
  [[nodiscard]] std::size_t zero_column() const noexcept;
};

}  // namespace odas
