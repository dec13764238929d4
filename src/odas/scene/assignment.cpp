// SPDX-License-Identifier: MIT
#include "odas/scene/assignment.hpp"

#include <limits>
#include <utility>

namespace odas {
namespace {

constexpr std::size_t kFree = std::numeric_limits<std::size_t>::max();

/// One partner for each row, rows <= columns.
std::vector<std::size_t> assign_rows(GridView<const double> cost) {
  const std::size_t rows = cost.rows();
  const std::size_t columns = cost.cols();
  std::vector<double> row_price(rows), column_price(columns), shortest(columns);
  std::vector<std::size_t> row_of(columns, kFree), column_of(rows, kFree), came_from(columns);
  std::vector<char> done(columns);

  for (std::size_t start = 0; start < rows; ++start) {
    shortest.assign(columns, std::numeric_limits<double>::infinity());
    done.assign(columns, 0);
    std::size_t row = start;
    std::size_t column = kFree;
    double length = 0;
    while (true) {
      column = kFree;
      for (std::size_t c = 0; c < columns; ++c) {
        if (done[c] != 0) continue;
        const double through = length + cost[row][c] - row_price[row] - column_price[c];
        if (through < shortest[c]) {
          shortest[c] = through;
          came_from[c] = row;
        }
        if (column == kFree || shortest[c] < shortest[column]) column = c;
      }
      length = shortest[column];
      done[column] = 1;
      if (row_of[column] == kFree) break;
      row = row_of[column];
    }
    // New prices keep every reduced cost at zero or more.
    row_price[start] += length;
    for (std::size_t c = 0; c < columns; ++c) {
      if (done[c] == 0) continue;
      if (row_of[c] != kFree) row_price[row_of[c]] += length - shortest[c];
      column_price[c] -= length - shortest[c];
    }
    // The path from the free column back to `start` changes its partners.
    while (true) {
      const std::size_t owner = came_from[column];
      row_of[column] = owner;
      std::swap(column_of[owner], column);
      if (owner == start) break;
    }
  }
  return column_of;
}

}  // namespace

std::vector<std::optional<std::size_t>> best_assignment(GridView<const double> cost) {
  std::vector<std::optional<std::size_t>> partner(cost.rows());
  if (cost.empty()) return partner;
  if (cost.rows() <= cost.cols()) {
    const auto columns = assign_rows(cost);
    for (std::size_t r = 0; r < columns.size(); ++r) partner[r] = columns[r];
    return partner;
  }
  Grid<double> turned(cost.cols(), cost.rows());
  for (std::size_t r = 0; r < cost.rows(); ++r) {
    for (std::size_t c = 0; c < cost.cols(); ++c) turned[c][r] = cost[r][c];
  }
  const auto rows = assign_rows(turned.view());
  for (std::size_t c = 0; c < rows.size(); ++c) partner[rows[c]] = c;
  return partner;
}

}  // namespace odas
