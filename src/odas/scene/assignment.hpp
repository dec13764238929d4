// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "odas/base/grid.hpp"

namespace odas {

/// The partner of each row, so that the sum of the costs is smallest; every row has one where there are at
/// least as many columns, else as many rows as there are columns have one.
///
/// Method: shortest augmenting paths with dual prices. Cost: O(n^2 m), n the smaller side, m the larger.
/// Source: Jonker and Volgenant, Computing 38, 1987; Crouse, IEEE TAES 52(4), 2016 (rectangular costs).
/// Shapes: cost [row][column], finite.
[[nodiscard]] std::vector<std::optional<std::size_t>> best_assignment(GridView<const double> cost);

}  // namespace odas
