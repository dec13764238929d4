// SPDX-License-Identifier: MIT
#include "odas/scene/bench_summary.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "odas/scene/bench_text.hpp"
#include "odas/scene/random.hpp"

namespace odas::bench_summary_test {
namespace {

TEST(Estimate, Interval_of_a_mean_is_about_that_of_a_Gaussian) {
  Random random(4);
  std::vector<double> values(400);
  for (double& x : values) x = 10 + static_cast<double>(random.uniform());
  const auto found = estimate(values, Middle::mean);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scenes, 400U);
  EXPECT_NEAR(found->value, 10, 0.15);
  const double half = 1.96 / std::sqrt(400.0);
  EXPECT_NEAR(found->value - found->low, half, 0.25 * half);
  EXPECT_NEAR(found->high - found->value, half, 0.25 * half);
}

TEST(Estimate, A_median_is_not_moved_by_what_never_came) {
  const auto found = estimate(std::vector<double>{0.1, 0.2, 0.3, 99, 0.2}, Middle::median);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, 0.2);
}

TEST(Estimate, Of_nothing_is_nothing_and_of_equals_is_sharp) {
  EXPECT_FALSE(estimate({}, Middle::mean));
  const auto found = estimate(std::vector<double>{3, 3, 3}, Middle::mean);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->low, 3);
  EXPECT_EQ(found->high, 3);
}

BenchOutcome outcome(const std::string& group, float snr, double recall) {
  BenchOutcome result;
  result.scene.group = group;
  result.scene.snr_db = snr;
  result.scene.array = "a";
  result.score.azimuth.tracks.recall = recall;
  return result;
}

TEST(BenchTables, Rows_are_the_levels_in_their_order_with_the_means_of_their_scenes) {
  const std::vector<BenchOutcome> outcomes{outcome("mixed", 0, 0.2), outcome("mixed", 20, 1),
                                           outcome("mixed", 0, 0.4), outcome("ego", 0, 0)};
  const auto figures = accuracy_figures();
  const auto tables = tables_of(outcomes, figures);
  ASSERT_EQ(tables[0].condition, "group");
  ASSERT_EQ(tables[0].rows.size(), 2U);
  EXPECT_EQ(tables[0].rows[0].name, "mixed");
  const auto by_snr = std::ranges::find(tables, "mixed, by SNR", &BenchTable::condition);
  ASSERT_NE(by_snr, tables.end());
  ASSERT_EQ(by_snr->rows.size(), 2U);
  EXPECT_EQ(by_snr->rows[0].name, "20 dB");
  EXPECT_EQ(by_snr->rows[1].name, "0 dB");
  EXPECT_EQ(by_snr->rows[1].scenes, 2U);
  ASSERT_TRUE(by_snr->rows[1].figures[0]);
  EXPECT_NEAR(by_snr->rows[1].figures[0]->value, 30, 1e-9);  // recall in %

  const std::string markdown = bench_markdown(tables, figures);
  EXPECT_NE(markdown.find("| mixed, by SNR | scenes | recall, % |"), std::string::npos);
  EXPECT_NE(markdown.find("| 20 dB | 1 | 100.0 |"), std::string::npos);
  const std::string json = bench_json(outcomes, tables, figures);
  EXPECT_NE(json.find("\"recall\":20.0"), std::string::npos);
}

}  // namespace
}  // namespace odas::bench_summary_test
