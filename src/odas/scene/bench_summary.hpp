// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "odas/scene/bench_run.hpp"

namespace odas {

/// A figure over several scenes, and between what it would come with other scenes of the kind, 95 times of
/// 100.
struct Estimate {
  double value = 0, low = 0, high = 0;
  std::size_t scenes = 0;
};

enum class Middle { mean, median };

/// Method: percentiles of 1000 bootstrap resamples (Efron, Ann. Statist. 7(1), 1979), of a generator of its
/// own, so that equal values give equal intervals. Empty for no values.
[[nodiscard]] std::optional<Estimate> estimate(std::span<const double> values, Middle middle);

/// A column of the table.
struct BenchFigure {
  std::string key;    // of JSON
  std::string title;  // with its unit
  int decimals = 1;
  Middle middle = Middle::mean;
  std::function<std::optional<double>(const BenchOutcome&)> of;
};
[[nodiscard]] std::vector<BenchFigure> accuracy_figures();
[[nodiscard]] std::vector<BenchFigure> separation_figures();

/// A row: the scenes that have something in common.
struct BenchRow {
  std::string name;
  std::size_t scenes = 0;
  std::vector<std::optional<Estimate>> figures;  // [figure]
};

/// Rows by the levels of one condition.
struct BenchTable {
  std::string condition;
  std::vector<BenchRow> rows;
};

/// By group, and within the group that mixes all conditions (the first) by each of them.
[[nodiscard]] std::vector<BenchTable> tables_of(std::span<const BenchOutcome> outcomes,
                                                std::span<const BenchFigure> figures);

}  // namespace odas
