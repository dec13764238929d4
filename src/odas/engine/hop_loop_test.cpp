// SPDX-License-Identifier: MIT
#include "odas/engine/hop_loop.hpp"

#include <algorithm>
#include <numeric>

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::hop_loop_test {
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
  const StageTimes stages = loop.metrics().stage_times;
  EXPECT_GT(stages[static_cast<std::size_t>(Stage::localization)], 0U);
  EXPECT_LE(std::accumulate(stages.begin(), stages.end(), std::uint64_t{0}),
            static_cast<std::uint64_t>(loop.metrics().hop_time.total().count()));
}

TEST(HopLoop, goes_on_in_silence_until_the_last_sound_has_come_out) {
  Configuration config = test::small_configuration();
  config.pipeline.sss.lookback = 40;
  Pipeline pipeline(config.pipeline);
  HopLoop loop(config, 3, 16000, pipeline);
  HopIndex last = 0;
  const auto take = [&](const HopResult& hop) { last = hop.time; };
  loop.push(test::noise(3, 128), take);
  EXPECT_EQ(last, 1U);
  loop.finish(true, take);
  EXPECT_EQ(last, 1U + 5U + 1U) << "through the look-back, and the overlap of two frames";
  HopLoop unused(config, 3, 16000, pipeline);
  last = 0;
  unused.finish(true, take);
  EXPECT_EQ(last, 0U) << "nothing was heard";
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

TEST(HopLoop, follows_the_targets_of_its_inbox_from_the_next_hop_on) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  TargetInbox inbox;
  HopLoop loop(config, 3, 16000, pipeline, &inbox);
  const Grid<float> block = test::noise(3, 128);
  std::size_t followed = 0;
  const auto count = [&](const HopResult& hop) {
    followed =
        static_cast<std::size_t>(std::count_if(hop.tracks.begin(), hop.tracks.end(), [](const Track& t) {
          return t.tag != "dynamic" && t.id != 0;
        }));
  };
  loop.push(block, count);
  EXPECT_EQ(followed, 0U);
  const std::vector<Target> five{
      {"a", {1, 0, 0}}, {"b", {0, 1, 0}}, {"c", {0, 0, 1}}, {"d", {-1, 0, 0}}, {"e", {0, -1, 0}}};
  inbox.change([&](TargetInbox::Orders& orders) { orders.targets.assign(five); });
  const auto before = test::allocations();
  loop.push(block, count);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(followed, 4U) << "there are four slots";
  EXPECT_EQ(inbox.unfollowed(), 1U);
  inbox.change([](TargetInbox::Orders& orders) { orders.targets.assign({}); });
  loop.push(block, count);
  EXPECT_EQ(followed, 0U);
  EXPECT_EQ(inbox.unfollowed(), 0U);
}

TEST(TargetInbox, gives_the_latest_orders_to_an_engine_that_was_far_behind) {
  const Configuration config = test::small_configuration();
  Pipeline pipeline(config.pipeline);
  TargetInbox inbox;
  for (int i = 0; i < 20; ++i) {
    const std::string tag = std::to_string(i);
    inbox.change([&](TargetInbox::Orders& orders) {
      orders.targets.assign(std::vector<Target>{{std::string_view(tag), {1, 0, 0}}});
    });
  }
  inbox.deliver(pipeline);
  inbox.retry();
  inbox.deliver(pipeline);
  const Grid<float> hop = test::noise(3, 128);
  EXPECT_EQ(pipeline.process_hop(hop).tracks[0].tag.view(), "19");
  EXPECT_EQ(inbox.orders().targets.view()[0].tag.view(), "19");
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
}  // namespace odas::hop_loop_test
