// SPDX-License-Identifier: MIT
#include "odas/io/net_address.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace odas::net_address_test {
namespace {

TEST(NetAddress, numbers_of_both_kinds_are_known_at_once) {
  for (const auto& [host, text] :
       {std::pair{"127.0.0.1", "127.0.0.1:9000"}, std::pair{"::1", "[::1]:9000"}}) {
    NameLookup lookup(host, 9000);
    const auto answer = lookup.poll();
    ASSERT_TRUE(answer) << host;
    ASSERT_EQ(answer->all.size(), 1U);
    EXPECT_EQ(answer->all[0].text(), text);
    EXPECT_EQ(answer->all[0].port(), 9000);
    EXPECT_FALSE(lookup.poll()) << "an answer is given once";
  }
}

TEST(NetAddress, a_name_is_looked_up_meanwhile) {
  NameLookup lookup("localhost", 9001);
  std::optional<NetAddresses> answer;
  for (int i = 0; i < 2000 && !answer; ++i) {
    answer = lookup.poll();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_TRUE(answer);
  ASSERT_FALSE(answer->all.empty()) << answer->fault;
  EXPECT_EQ(answer->all[0].port(), 9001);
}

TEST(NetAddress, a_name_that_cannot_be_is_a_fault_that_names_it) {
  const NetAddresses answer = look_up("no such host", 9000);
  EXPECT_TRUE(answer.all.empty());
  EXPECT_NE(answer.fault.find("\"no such host\" is not known as a host"), std::string::npos) << answer.fault;
}

}  // namespace
}  // namespace odas::net_address_test
