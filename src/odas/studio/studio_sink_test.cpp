// SPDX-License-Identifier: MIT
#include "odas/studio/studio_sink.hpp"

#include <gtest/gtest.h>

namespace odas::studio_sink_test {
namespace {

class Listener final : public HopListener {
 public:
  void begin(const StreamInfo&) override {}
  void change(const StreamInfo& info) override { runs.push_back(info.run); }
  void hop(const HopResult& hop) override { hops.push_back(hop.time); }
  void end() override {}
  std::vector<std::uint64_t> runs;
  std::vector<HopIndex> hops;
};

TEST(StudioSink, hands_every_hop_to_all_and_says_before_it_that_the_run_goes_on_otherwise) {
  Listener one, two;
  const std::vector<HopListener*> listeners{&one, &two};
  StudioSink sink(listeners, {}, std::make_shared<RunFigures>());
  EXPECT_TRUE(sink.wanted().mics && sink.wanted().power_map && sink.wanted().separated);
  HopResult hop;
  hop.time = 1;
  EXPECT_TRUE(sink.write(hop).ok());
  StreamInfo info;
  info.run = 9;
  sink.change(info);
  EXPECT_TRUE(one.runs.empty());
  hop.time = 2;
  EXPECT_TRUE(sink.write(hop).ok());
  EXPECT_EQ(one.runs, std::vector<std::uint64_t>{9});
  EXPECT_EQ(two.hops, (std::vector<HopIndex>{1, 2}));
}

}  // namespace
}  // namespace odas::studio_sink_test
