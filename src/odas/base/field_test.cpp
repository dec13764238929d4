// SPDX-License-Identifier: MIT
#include "odas/base/field.hpp"

#include <gtest/gtest.h>

namespace odas::field_test {
namespace {

struct Leaf {
  float size = 1;
  static Schema schema() {
    static const std::vector<Field> fields{field<&Leaf::size>("size", "m", kPositive, "how large").must()};
    return fields;
  }
};

struct Tree {
  int age = 3;
  std::array<float, 2> place{};
  Leaf best;
  std::vector<Leaf> leaves;
  std::optional<std::vector<Leaf>> fallen;
  static Schema schema() {
    static const std::vector<Field> fields{
        field<&Tree::age>("age", "years", kNotNegative, "since planting"),
        field<&Tree::place>("place", "m", kAny, "x, y"),
        field<&Tree::best>("best", "", kAny, "the best leaf"),
        field<&Tree::leaves>("leaves", "", kAny, "all leaves"),
        field<&Tree::fallen>("fallen", "", kAny, "those that fell"),
    };
    return fields;
  }
};

TEST(Field, Reaches_the_member_that_it_describes) {
  Tree tree;
  *std::get<int*>(Tree::schema()[0].value(&tree)) = 40;
  std::get<std::span<float>>(Tree::schema()[1].value(&tree))[1] = 2;
  EXPECT_EQ(tree.age, 40);
  EXPECT_EQ(tree.place[1], 2);
}

TEST(Field, Leads_into_groups_and_lists) {
  Tree tree;
  const auto best = std::get<GroupRef>(Tree::schema()[2].value(&tree));
  *std::get<float*>(best.schema[0].value(best.object)) = 9;
  EXPECT_EQ(tree.best.size, 9);
  const auto leaves = std::get<ListRef>(Tree::schema()[3].value(&tree));
  leaves.resize(2);
  *std::get<float*>(leaves.schema()[0].value(leaves.at(1))) = 5;
  ASSERT_EQ(tree.leaves.size(), 2U);
  EXPECT_EQ(tree.leaves[1].size, 5);
}

TEST(Field, Tells_an_absent_list_from_an_empty_one) {
  Tree tree;
  const auto fallen = std::get<ListRef>(Tree::schema()[4].value(&tree));
  EXPECT_EQ(fallen.size(), 0U);
  EXPECT_FALSE(tree.fallen.has_value());
  fallen.resize(0);
  EXPECT_TRUE(tree.fallen.has_value());
}

TEST(Range, Includes_its_bounds_unless_told_otherwise) {
  EXPECT_TRUE(kUnit.contains(0));
  EXPECT_TRUE(kUnit.contains(1));
  EXPECT_FALSE(kUnit.contains(1.001));
  EXPECT_FALSE(kPositive.contains(0));
  EXPECT_TRUE(Leaf::schema()[0].required);
}

}  // namespace
}  // namespace odas::field_test
