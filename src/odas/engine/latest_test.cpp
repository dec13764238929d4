// SPDX-License-Identifier: MIT
#include "odas/engine/latest.hpp"

#include <thread>

#include <gtest/gtest.h>

namespace odas::latest_test {
namespace {

struct Pair {
  std::uint64_t a = 0, b = 0;
};

TEST(Latest, gives_the_last_value_as_often_as_it_is_asked) {
  Latest<int> latest;
  EXPECT_EQ(latest.get(), 0);
  latest.put(1);
  latest.put(2);
  EXPECT_EQ(latest.get(), 2);
  EXPECT_EQ(latest.get(), 2);
  latest.put(3);
  EXPECT_EQ(latest.get(), 3);
}

TEST(Latest, never_gives_half_a_value_nor_an_older_one_after_a_newer) {
  constexpr std::uint64_t kLast = 100000;
  Latest<Pair> latest;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kLast; ++i) latest.put({i, 2 * i});
  });
  std::uint64_t before = 0;
  while (before < kLast) {
    const Pair got = latest.get();
    ASSERT_EQ(got.b, 2 * got.a);
    ASSERT_GE(got.a, before);
    before = got.a;
  }
  writer.join();
}

}  // namespace
}  // namespace odas::latest_test
