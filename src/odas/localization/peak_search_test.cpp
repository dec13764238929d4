// SPDX-License-Identifier: MIT
#include "odas/localization/peak_search.hpp"

#include <algorithm>
#include <random>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

namespace odas::peak_search_test {
namespace {

Grid<float> random_correlations(const SearchPlan& plan, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Grid<float> x(plan.pairs.size(), plan.row_size);
  for (std::size_t q = 0; q < x.rows(); ++q) {
    for (std::size_t n = 0; n <= 2 * plan.half_lags; ++n) x[q][n] = uniform(random);
  }
  return x;
}

/// E of a direction of the finest grid, as the definition has it.
float naive(const SearchPlan& plan, const Grid<float>& x, std::size_t point) {
  float sum = 0;
  float pairs = 0;
  for (std::size_t q = 0; q < plan.pairs.size(); ++q) {
    if (plan.fine_heard[point][q] == 0) continue;
    const auto delta = static_cast<int>(plan.levels.back().deltas[q]);
    const int column = static_cast<int>(plan.half_lags) + plan.fine_lags[point][q];
    float best = -2;
    for (int n = column - delta; n <= column + delta; ++n) best = std::max(best, x[q][std::size_t(n)]);
    sum += best;
    pairs += 1;
  }
  return pairs > 0 ? sum / pairs : -2;
}

TEST(PeakSearch, With_one_level_finds_what_an_exhaustive_search_finds) {
  const GeneralConfig general = test::tetrahedron(0.15F);
  SslConfig ssl;
  for (const int delta : {0, 1}) {
    ssl.scans = {{3, delta}};
    const SearchPlan plan(general, ssl);
    PeakSearch search(plan);
    const Grid<float> x = random_correlations(plan, 7);
    float best = -2;
    for (std::size_t u = 0; u < plan.fine_lags.rows(); ++u) best = std::max(best, naive(plan, x, u));
    std::vector<float> map(plan.levels.front().directions.size());
    const PeakSearch::Peak peak = search.strongest(plan, x, map);
    EXPECT_FLOAT_EQ(peak.energy, best);
    EXPECT_FLOAT_EQ(naive(plan, x, peak.point), best);
    EXPECT_FLOAT_EQ(*std::max_element(map.begin(), map.end()), best);
  }
}

TEST(PeakSearch, With_two_levels_ends_at_a_direction_of_the_finest_grid) {
  const GeneralConfig general = test::ring(5, 0.05F);
  const SearchPlan plan(general, {});
  PeakSearch search(plan);
  const Grid<float> x = random_correlations(plan, 8);
  const PeakSearch::Peak peak = search.strongest(plan, x, {});
  EXPECT_FLOAT_EQ(naive(plan, x, peak.point), peak.energy);
}

}  // namespace
}  // namespace odas::peak_search_test
