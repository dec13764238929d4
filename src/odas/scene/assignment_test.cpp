// SPDX-License-Identifier: MIT
#include "odas/scene/assignment.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace odas::assignment_test {
namespace {

/// The smallest sum, by trying every order of the larger side.
double smallest_sum(const Grid<double>& cost) {
  const std::size_t large = std::max(cost.rows(), cost.cols());
  const std::size_t small = std::min(cost.rows(), cost.cols());
  std::vector<std::size_t> order(large);
  std::iota(order.begin(), order.end(), 0U);
  double best = 1e300;
  do {
    double sum = 0;
    for (std::size_t i = 0; i < small; ++i) {
      sum += cost.rows() <= cost.cols() ? cost[i][order[i]] : cost[order[i]][i];
    }
    best = std::min(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(Assignment, finds_the_smallest_sum_of_all_orders_in_every_shape_up_to_6_by_6) {
  std::mt19937 random(7);
  for (std::size_t rows = 1; rows <= 6; ++rows) {
    for (std::size_t columns = 1; columns <= 6; ++columns) {
      for (int trial = 0; trial < 10; ++trial) {
        Grid<double> cost(rows, columns);
        // Few values, so that ties come up too.
        for (std::size_t r = 0; r < rows; ++r) {
          for (double& value : cost[r]) value = static_cast<double>(random() % 12);
        }
        const auto partner = best_assignment(cost.view());
        double sum = 0;
        std::vector<int> taken(columns, 0);
        std::size_t partners = 0;
        for (std::size_t r = 0; r < rows; ++r) {
          if (!partner[r]) continue;
          sum += cost[r][*partner[r]];
          ++taken[*partner[r]];
          ++partners;
        }
        EXPECT_EQ(partners, std::min(rows, columns));
        EXPECT_LE(*std::max_element(taken.begin(), taken.end()), 1);
        EXPECT_DOUBLE_EQ(sum, smallest_sum(cost)) << rows << " x " << columns;
      }
    }
  }
}

TEST(Assignment, gives_up_the_nearest_pair_where_the_whole_gains) {
  Grid<double> cost(2, 2);
  cost[0][0] = 1;
  cost[0][1] = 2;
  cost[1][0] = 2;
  cost[1][1] = 9;
  const auto partner = best_assignment(cost.view());
  EXPECT_EQ(partner[0], 1U);
  EXPECT_EQ(partner[1], 0U);
}

TEST(Assignment, of_nothing_is_nothing) {
  EXPECT_TRUE(best_assignment(GridView<const double>()).empty());
  const Grid<double> no_columns(3, 0);
  const auto partner = best_assignment(no_columns.view());
  EXPECT_EQ(partner.size(), 3U);
  EXPECT_FALSE(partner[0].has_value());
}

}  // namespace
}  // namespace odas::assignment_test
