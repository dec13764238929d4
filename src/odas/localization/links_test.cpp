// SPDX-License-Identifier: MIT
#include "odas/localization/links.hpp"

#include <algorithm>
#include <set>

#include "support/plane_wave.hpp"
#include <gtest/gtest.h>

#include "odas/array/directivity.hpp"
#include "odas/localization/delta_training.hpp"

namespace odas::links_test {
namespace {

struct Levels {
  explicit Levels(const GeneralConfig& general)
      : pairs(all_pairs(general.mics.size())),
        coarse(general, Directivity(general), pairs, 2, 4),
        fine(general, Directivity(general), pairs, 3, 4),
        coarse_deltas(train_deltas(general, {}, coarse, pairs)),
        fine_deltas(train_deltas(general, {}, fine, pairs)) {}
  std::vector<Pair> pairs;
  ScanLevel coarse, fine;
  std::vector<int> coarse_deltas, fine_deltas;
};

TEST(Links, Reach_every_fine_direction_from_as_many_coarse_ones_as_asked) {
  const Levels l(test::ring(8, 0.1F));
  const auto links = link_levels(l.coarse, l.coarse_deltas, l.fine, l.fine_deltas, 10);
  std::vector<int> reached(l.fine.grid().size(), 0);
  for (const auto& fines : links) {
    EXPECT_TRUE(std::is_sorted(fines.begin(), fines.end()));
    EXPECT_EQ(std::set<std::size_t>(fines.begin(), fines.end()).size(), fines.size()) << "none twice";
    for (const std::size_t f : fines) ++reached[f];
  }
  for (const int count : reached) EXPECT_EQ(count, 10);
}

TEST(Links, Lead_to_what_is_near) {
  const Levels l(test::tetrahedron(0.15F));  // no two directions are alike to it
  const auto links = link_levels(l.coarse, l.coarse_deltas, l.fine, l.fine_deltas, 1);
  for (std::size_t c = 0; c < links.size(); ++c) {
    for (const std::size_t f : links[c]) {
      EXPECT_LT(test::angle_deg(l.coarse.grid().points()[c], l.fine.grid().points()[f]), 30) << c << " " << f;
    }
  }
}

TEST(Links, Leave_nothing_out_where_nothing_overlaps) {
  const Levels l(test::ring(3, 1.0F));  // metres apart: windows are far narrower than the grid is coarse
  const std::vector<int> none(l.pairs.size(), 0);
  const auto links = link_levels(l.coarse, none, l.fine, none, 10);
  std::vector<bool> reached(l.fine.grid().size(), false);
  for (const auto& fines : links) {
    for (const std::size_t f : fines) reached[f] = true;
  }
  EXPECT_TRUE(std::all_of(reached.begin(), reached.end(), [](bool r) { return r; }));
}

}  // namespace
}  // namespace odas::links_test
