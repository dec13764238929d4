// SPDX-License-Identifier: MIT
#include "odas/scene/bench_text.hpp"

#include <gtest/gtest.h>

namespace odas::bench_text_test {
namespace {

TEST(BenchMarkdown, Tells_a_figure_with_its_interval_and_a_dash_where_there_is_none) {
  std::vector<BenchFigure> figures(2);
  figures[0].title = "recall, %";
  figures[1].title = "error, deg";
  BenchTable table{"group", {}};
  table.rows.push_back({"mixed", 3, {Estimate{97.06, 94, 98.9, 3}, std::nullopt}});
  EXPECT_EQ(bench_markdown(std::vector{table}, figures),
            "| group | scenes | recall, % | error, deg |\n|---|---|---|---|\n"
            "| mixed | 3 | 97.1 (94.0, 98.9) | - |\n");
}

}  // namespace
}  // namespace odas::bench_text_test
