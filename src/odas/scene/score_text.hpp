// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/scene/score.hpp"

namespace odas {

/// A table to read. Figures that do not exist are a dash.
[[nodiscard]] std::string score_table(const Score& score);

/// One JSON object on one line: recall, az_recall, sdr, ...; docs/scenes.md says what each is. Figures that
/// do not exist are left out or, where a scene has sources, null.
[[nodiscard]] std::string score_json(const Score& score);

}  // namespace odas
