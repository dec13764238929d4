// SPDX-License-Identifier: MIT
#include "odas/studio/own_address.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>

namespace odas::own_address_test {
namespace {

TEST(OwnAddress, is_a_number_that_leads_beyond_this_machine_or_nothing) {
  const std::string address = own_address();
  if (address.empty()) GTEST_SKIP() << "this machine is in no network";
  in_addr number{};
  EXPECT_EQ(::inet_pton(AF_INET, address.c_str(), &number), 1) << address;
  EXPECT_FALSE(address.starts_with("127."));
}

}  // namespace
}  // namespace odas::own_address_test
