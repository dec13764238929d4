// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/geometry.hpp"
#include "odas/localization/config.hpp"
#include "odas/localization/scan_level.hpp"

namespace odas {

/// Finds for each pair the half-width of the sliding maximum over lags (`delta < 0` in a scan): as narrow as
/// may be, yet so wide that a source anywhere between the grid's points is caught by the nearest point.
///
/// Method: around each point lies a patch of directions. The delay of a pair from there is Gaussian (position
/// of the microphones and speed of sound are uncertain); its probability to fall within lag +- delta + 1/2 is
/// a difference of two error functions. Deltas grow one by one, always that of the pair that covers least,
/// until every direction is covered with `prob_min` on average over its pairs.
/// Source: Grondin and Michaud, "Lightweight and optimized sound source localization and tracking methods for
/// open and closed microphone array configurations", 2019, section 3.1.
/// Errors: where `prob_min` cannot be reached the training ends once no delta that grows helps (ODAS never
/// ended).
[[nodiscard]] std::vector<int> train_deltas(const GeneralConfig& general, const SslConfig& ssl,
                                            const ScanLevel& level, std::span<const Pair> pairs);

}  // namespace odas
