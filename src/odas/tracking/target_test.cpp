// SPDX-License-Identifier: MIT
#include "odas/tracking/target.hpp"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace odas::target_test {
namespace {

TEST(TargetList, leaves_out_what_cannot_be_followed_and_counts_it) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Target> targets{{"door", {2, 0, 0}}, {"", {1, 0, 0}},     {"dynamic", {1, 0, 0}},
                                    {"a", {0, 0, 0}},    {"b", {nan, 0, 1}},  {"c", {1e30F, 1e30F, 0}},
                                    {"door", {0, 1, 0}}, {"desk", {0, 0, -3}}};
  TargetList list;
  EXPECT_EQ(list.assign(targets), 6U);
  ASSERT_EQ(list.view().size(), 2U);
  EXPECT_EQ(list.view()[0], (Target{"door", {1, 0, 0}})) << "the first of its tag, length 1";
  EXPECT_EQ(list.view()[1], (Target{"desk", {0, 0, -1}}));
  EXPECT_EQ(list.find("desk"), &list.view()[1]);
  EXPECT_EQ(list.find("a"), nullptr);
}

TEST(TargetList, keeps_the_first_64) {
  std::vector<Target> targets;
  for (int i = 0; i < 70; ++i) targets.push_back({std::string_view(std::to_string(i)), {0, 0, 1}});
  TargetList list;
  EXPECT_EQ(list.assign(targets), 6U);
  EXPECT_EQ(list.view().back().tag.view(), "63");
  EXPECT_EQ(list.assign({}), 0U);
  EXPECT_TRUE(list.view().empty());
}

}  // namespace
}  // namespace odas::target_test
