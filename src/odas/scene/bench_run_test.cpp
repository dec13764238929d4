// SPDX-License-Identifier: MIT
#include "odas/scene/bench_run.hpp"

#include <atomic>

#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::bench_run_test {
namespace {

TEST(BenchParallel, Does_each_piece_once_and_throws_what_one_of_them_threw) {
  std::vector<std::atomic<int>> done(50);
  for_each_in_parallel(done.size(), 3, nullptr, {}, [&](std::size_t i) { ++done[i]; });
  for (const auto& count : done) EXPECT_EQ(count, 1);
  EXPECT_THROW(for_each_in_parallel(9, 2, nullptr, {},
                                    [](std::size_t i) {
                                      if (i == 4) throw IoError("the fifth");
                                    }),
               IoError);
}

}  // namespace
}  // namespace odas::bench_run_test
