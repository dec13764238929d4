// SPDX-License-Identifier: MIT
#include "odas/engine/pipeline_inbox.hpp"

#include "support/allocation_counter.hpp"
#include "support/fake_io.hpp"
#include <gtest/gtest.h>

namespace odas::pipeline_inbox_test {
namespace {

TEST(PipelineInbox, puts_a_new_pipeline_into_the_place_of_the_running_one_without_an_allocation) {
  PipelineConfig config = test::small_configuration().pipeline;
  config.sst.add = "static";
  config.sst.target = {{"first", 1, 0, 0}};
  Pipeline running(config);
  const Grid<float> hop = test::noise(config.general.mics.size(), running.hop_size());
  const std::uint64_t id = running.process_hop(hop).tracks[0].id;

  PipelineInbox inbox;
  inbox.deliver(running);
  EXPECT_EQ(running.process_hop(hop).time, 2U) << "nothing has come";
  inbox.post(std::make_unique<Pipeline>(config));
  inbox.post(std::make_unique<Pipeline>(config));
  EXPECT_FALSE(inbox.tidy());
  const auto before = test::allocations();
  inbox.deliver(running);
  EXPECT_EQ(test::allocations(), before);
  const HopResult result = running.process_hop(hop);
  EXPECT_EQ(result.time, 3U);
  EXPECT_EQ(result.tracks[0].id, id);

  inbox.post(std::make_unique<Pipeline>(config));
  inbox.deliver(running);
  EXPECT_TRUE(inbox.tidy() == false) << "the old one is still there, so the new one waits";
  inbox.deliver(running);
  EXPECT_TRUE(inbox.tidy());
  EXPECT_EQ(running.process_hop(hop).time, 4U);
}

}  // namespace
}  // namespace odas::pipeline_inbox_test
