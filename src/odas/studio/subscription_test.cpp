// SPDX-License-Identifier: MIT
#include "odas/studio/subscription.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/studio/rpc.hpp"

namespace odas::subscription_test {
namespace {

using nlohmann::json;

TEST(Subscription, is_read_and_becomes_a_demand) {
  const Subscription read = read_subscription(
      json::parse(R"({"topics":{"hops":1000,"power":5,"of the future":1},"potentials":false,)"
                  R"("audio":[{"stream":"postfiltered","track":12},{"stream":"raw","mic":2}]})"));
  EXPECT_EQ(read.rate_of("hops"), Subscription::kMostPerSecond);
  EXPECT_EQ(read.rate_of("meters"), 0);
  EXPECT_EQ(read.audio[1], (Subscription::Audio{AudioStream::raw, 2}));
  HopRing::Demand demand;
  read.add_to(demand);
  HopRing::Demand expected;
  expected.bare = expected.power = true;
  expected.audio[1] = expected.audio[2] = true;
  EXPECT_EQ(demand, expected);
}

TEST(Subscription, of_nothing_demands_nothing) {
  HopRing::Demand demand;
  read_subscription(json::object()).add_to(demand);
  EXPECT_EQ(demand, HopRing::Demand());
}

TEST(Subscription, says_what_it_does_not_understand) {
  for (const char* text :
       {R"({"topics":{"hops":"fast"}})", R"({"topics":5})", R"({"audio":[{"stream":"music","track":1}]})",
        R"({"audio":[{"stream":"raw","track":1}]})", R"({"audio":[7]})"}) {
    EXPECT_THROW(static_cast<void>(read_subscription(json::parse(text))), RpcError) << text;
  }
  json many = {{"audio", json::array()}};
  for (int i = 0; i < 17; ++i) many["audio"].push_back({{"stream", "raw"}, {"mic", 1}});
  EXPECT_THROW(static_cast<void>(read_subscription(many)), RpcError);
}

}  // namespace
}  // namespace odas::subscription_test
