// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "odas/scene/bench_summary.hpp"

namespace odas {

/// A panel of the picture: a figure by the levels of a condition, perhaps with another figure beside it.
struct BenchPanel {
  std::string condition;  // as in the table: "mixed, by SNR"
  std::string title;
  std::vector<std::string> figures;  // keys
  std::optional<double> top;         // of the axis
};

/// Draws the panels whose tables there are, three a row, as SVG.
[[nodiscard]] std::string bench_svg(const std::string& title, std::span<const BenchTable> tables,
                                    std::span<const BenchFigure> figures, std::span<const BenchPanel> panels);

[[nodiscard]] std::vector<BenchPanel> accuracy_panels();
[[nodiscard]] std::vector<BenchPanel> separation_panels();

}  // namespace odas
