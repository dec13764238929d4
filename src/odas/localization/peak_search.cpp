// SPDX-License-Identifier: MIT
#include "odas/localization/peak_search.hpp"

#include <algorithm>
#include <limits>

#include "odas/localization/kernels.hpp"

namespace odas {
namespace {

std::size_t largest_cell(const SearchPlan& plan) {
  std::size_t largest = 0;
  for (const auto& level : plan.levels) {
    for (const auto& cell : level.cells) largest = std::max(largest, cell.columns.cols());
  }
  return largest;
}

}  // namespace

PeakSearch::PeakSearch(const SearchPlan& plan)
    : maxima_(plan.pairs.size(), plan.row_size), rows_(plan.pairs.size()), sums_(largest_cell(plan)) {}

PeakSearch::Peak PeakSearch::strongest(const SearchPlan& plan, GridView<const float> correlations,
                                       std::span<float> map) noexcept {
  Peak winner;
  for (std::size_t l = 0; l < plan.levels.size(); ++l) {
    const SearchPlan::Level& level = plan.levels[l];
    for (std::size_t q = 0; q < rows_.size(); ++q) {
      rows_[q] = correlations[q].data();
      if (level.deltas[q] == 0) continue;
      sliding_max(rows_[q], level.first[q], level.last[q], level.deltas[q], maxima_[q].data());
      rows_[q] = maxima_[q].data();
    }
    const SearchPlan::Cell& cell = level.cells[l == 0 ? 0 : winner.point];
    gather_sums(rows_, cell.columns, sums_);
    if (l == 0 && !map.empty()) {
      for (std::size_t c = 0; c < cell.points.size(); ++c) map[cell.points[c]] = sums_[c] / cell.pairs[c];
    }
    std::size_t best = 0;
    winner.energy = -std::numeric_limits<float>::infinity();
    for (std::size_t c = 0; c < cell.points.size(); ++c) {
      const float mean = sums_[c] / cell.pairs[c];
      if (mean > winner.energy) {
        winner.energy = mean;
        best = c;
      }
    }
    // Where all was cut out there is nothing to find: E is 0, and no direction is better than another. Then
    // the number of the coarse winner stands, in the finest grid too, as ODAS prints it.
    if (winner.energy != 0 || l == 0) winner.point = cell.points[best];
  }
  return winner;
}

}  // namespace odas
