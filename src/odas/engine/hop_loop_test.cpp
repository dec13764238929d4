// SPDX-License-Identifier: MIT
#include "odas/engine/hop_loop.hpp"

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

TEST(HopLoop, gives_a_result_for_each_hop_and_counts_them) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  HopLoop loop(config, 3, 16000, pipeline);
  std::vector<HopIndex> times;
  const auto take = [&](const HopResult& hop) { times.push_back(hop.time); };
  for (int i = 0; i < 3; ++i) loop.push(test::noise(3, 128), take);
  loop.push(test::noise(3, 5), take);
  loop.finish(true, take);
  EXPECT_EQ(times, (std::vector<HopIndex>{1, 2, 3, 4}));
  EXPECT_EQ(loop.metrics().hops, 4U);
  EXPECT_DOUBLE_EQ(loop.metrics().sound_seconds, 4 * 0.008);
  EXPECT_GT(loop.metrics().hop_time.total().count(), 0);
}

TEST(HopLoop, loses_the_rest_where_it_is_not_padded) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  HopLoop loop(config, 3, 16000, pipeline);
  int hops = 0;
  loop.push(test::noise(3, 5), [&](const HopResult&) { ++hops; });
  loop.finish(false, [&](const HopResult&) { ++hops; });
  EXPECT_EQ(hops, 0);
}

TEST(HopLoop, counts_samples_that_are_not_finite) {
  const Configuration config = test::small_configuration();
  for (const int rate : {16000, 32000}) {
    Pipeline pipeline(config.pipeline);
    HopLoop loop(config, 3, rate, pipeline);
    Grid<float> block = test::noise(3, 128);
    block[1][7] = std::numeric_limits<float>::quiet_NaN();
    loop.push(block, [](const HopResult&) {});
    loop.finish(true, [](const HopResult&) {});
    EXPECT_EQ(loop.metrics().non_finite_samples, 1U) << rate;
  }
}

TEST(HopLoop, allocates_nothing_once_it_runs) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  HopLoop loop(config, 3, 16000, pipeline);
  const Grid<float> block = test::noise(3, 128);
  const auto before = test::allocations();
  for (int i = 0; i < 50; ++i) loop.push(block, [](const HopResult&) {});
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace odas
