// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "odas/localization/search_plan.hpp"

namespace odas {

/// Finds the direction of the highest steered response, from coarse to fine: the coarsest level is searched
/// whole, each finer one around the winner of the one above. E(u) = mean over the pairs that hear u of the
/// largest correlation within delta of u's lag.
class PeakSearch {
 public:
  explicit PeakSearch(const SearchPlan& plan);

  struct Peak {
    std::size_t point = 0;  // of the finest grid
    float energy = 0;
  };
  /// correlations [pair][column]. `map`, where not empty, takes E of each direction of the coarsest grid.
  [[nodiscard]] Peak strongest(const SearchPlan& plan, GridView<const float> correlations,
                               std::span<float> map) noexcept;

 private:
  Grid<float> maxima_;              // [pair][column]
  std::vector<const float*> rows_;  // [pair]: of the correlations, or of maxima_ where delta > 0
  std::vector<float> sums_;         // [candidate]
};

}  // namespace odas
