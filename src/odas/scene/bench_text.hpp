// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "odas/scene/bench_summary.hpp"

namespace odas {

/// Markdown: a table a condition, "97.1 (94.0, 98.9)" a figure.
[[nodiscard]] std::string bench_markdown(std::span<const BenchTable> tables,
                                         std::span<const BenchFigure> figures);

/// One JSON object: `scenes`, each with its conditions and figures, and `tables`.
[[nodiscard]] std::string bench_json(std::span<const BenchOutcome> outcomes,
                                     std::span<const BenchTable> tables,
                                     std::span<const BenchFigure> figures);

}  // namespace odas
