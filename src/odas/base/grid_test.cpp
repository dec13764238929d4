// SPDX-License-Identifier: MIT
#include "odas/base/grid.hpp"

#include <gtest/gtest.h>

namespace odas::grid_test {
namespace {

TEST(Grid, Begins_with_zeros_and_keeps_rows_apart) {
  Grid<int> grid(3, 4);
  for (std::size_t r = 0; r < 3; ++r) {
    for (const int x : grid[r]) EXPECT_EQ(x, 0);
  }
  grid[1][3] = 7;
  EXPECT_EQ(grid[2][0], 0);
  EXPECT_EQ(grid.data()[1 * 4 + 3], 7);
}

TEST(GridView, Steps_over_what_lies_between_its_rows) {
  Grid<int> grid(2, 10);
  for (int i = 0; i < 20; ++i) grid.data()[i] = i;
  const GridView<const int> part(grid.data() + 3, 2, 4, 10);
  EXPECT_EQ(part[0][0], 3);
  EXPECT_EQ(part[1][3], 16);
  EXPECT_EQ(part[1].size(), 4U);
}

TEST(GridView, Of_mutable_values_is_also_one_of_constant_ones) {
  Grid<int> grid(1, 1);
  GridView<int> view = grid;
  const GridView<const int> constant = view;
  view[0][0] = 5;
  EXPECT_EQ(constant[0][0], 5);
}

#ifdef ODAS_CHECK_CONTRACTS
TEST(GridView, Does_not_let_a_row_be_read_that_is_not_there) {
  Grid<int> grid(2, 2);
  EXPECT_DEATH(static_cast<void>(grid[2]), "row < rows_");
}
#endif

}  // namespace
}  // namespace odas::grid_test
