// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/localization/scan_level.hpp"

namespace odas {

/// For each direction of a coarse grid, the directions of the next finer one that are searched once it has
/// won: [coarse point] -> fine points, rising.
///
/// Method: each fine direction is reached from the `matches` coarse ones whose lag windows (lag +- delta,
/// summed over the pairs that hear both) overlap most with its own.
/// A fine direction that overlaps with fewer than `matches` coarse ones has fewer links (ODAS links it to
/// coarse direction 0 instead); one that overlaps with none is linked to the coarse direction nearest to it,
/// so that every direction can be found.
/// Source: Grondin and Michaud, 2019, algorithm 3.
[[nodiscard]] std::vector<std::vector<std::size_t>> link_levels(const ScanLevel& coarse,
                                                                std::span<const int> coarse_deltas,
                                                                const ScanLevel& fine,
                                                                std::span<const int> fine_deltas,
                                                                int matches);

}  // namespace odas
