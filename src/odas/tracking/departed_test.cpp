// SPDX-License-Identifier: MIT
#include "odas/tracking/departed.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace odas::departed_test {
namespace {

TEST(Departed, are_known_again_within_the_time_and_no_later) {
  Departed departed(10);
  const Vec3 u = direction_of(30, 0);
  departed.add(7, u, 2);
  for (int hop = 0; hop < 10; ++hop) departed.age();
  ASSERT_TRUE(departed.nearest(u));
  departed.age();
  EXPECT_FALSE(departed.nearest(u));
}

TEST(Departed, are_known_again_near_their_place_only_and_once) {
  Departed departed(10);
  departed.add(7, direction_of(30, 0), 2);
  EXPECT_FALSE(departed.nearest(direction_of(30 + Departed::kNear + 1, 0)));
  const auto match = departed.nearest(direction_of(30 - Departed::kNear + 1, 0));
  ASSERT_TRUE(match);
  const Departed::Source source = departed.take(match->place);
  EXPECT_EQ(source.id, 7U);
  EXPECT_EQ(source.slot, 2U);
  EXPECT_FALSE(departed.nearest(direction_of(30, 0)));
}

TEST(Departed, give_the_nearest) {
  Departed departed(10);
  departed.add(1, direction_of(10, 0), 2);
  departed.add(2, direction_of(24, 0), 2);
  EXPECT_EQ(departed.take(departed.nearest(direction_of(18, 0))->place).id, 2U);
  EXPECT_EQ(departed.take(departed.nearest(direction_of(18, 0))->place).id, 1U);
}

TEST(Departed, are_none_where_no_time_is_given) {
  Departed departed(0);
  departed.add(1, {0, 0, 1}, 2);
  departed.age();
  EXPECT_FALSE(departed.nearest({0, 0, 1}));
}

TEST(Departed, are_the_latest_64_and_the_oldest_goes_first) {
  Departed departed(1000);
  const auto place = [](int i) {  // Fibonacci's sphere: no two of the 65 are near each other
    const float z = 1 - (2 * static_cast<float>(i) + 1) / 65;
    return direction_of(137.50776F * static_cast<float>(i), degrees(std::asin(z)));
  };
  for (int i = 0; i < 65; ++i) {
    departed.add(static_cast<std::uint64_t>(i) + 1, place(i), 2);
    departed.age();
  }
  EXPECT_FALSE(departed.nearest(place(0))) << "it was the oldest";
  for (int i = 1; i < 65; ++i) {
    const auto match = departed.nearest(place(i));
    ASSERT_TRUE(match) << i;
    EXPECT_EQ(departed.take(match->place).id, static_cast<std::uint64_t>(i) + 1);
  }
}

}  // namespace
}  // namespace odas::departed_test
