// SPDX-License-Identifier: MIT
#include "odas/io/allowed_senders.hpp"

#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::allowed_senders_test {
namespace {

NetAddress address(const std::string& host) {
  const NetAddresses found = look_up(host, 1234);
  EXPECT_EQ(found.fault, "");
  return found.all.at(0);
}

TEST(AllowedSenders, this_machine_always_may) {
  const AllowedSenders nobody{{}};
  EXPECT_TRUE(nobody.allows(address("127.0.0.1")));
  EXPECT_TRUE(nobody.allows(address("127.3.2.1")));
  EXPECT_TRUE(nobody.allows(address("::1")));
  EXPECT_TRUE(nobody.allows(address("::ffff:127.0.0.1")));
  EXPECT_FALSE(nobody.allows(address("192.0.2.1")));
  EXPECT_FALSE(nobody.allows(address("2001:db8::1")));
}

TEST(AllowedSenders, those_who_are_named_may_by_either_kind_of_address) {
  const AllowedSenders two({"192.0.2.1", "2001:db8::7"});
  EXPECT_TRUE(two.allows(address("192.0.2.1")));
  EXPECT_TRUE(two.allows(address("::ffff:192.0.2.1")));
  EXPECT_TRUE(two.allows(address("2001:db8::7")));
  EXPECT_FALSE(two.allows(address("192.0.2.2")));
  EXPECT_FALSE(two.allows(address("2001:db8::8")));
}

TEST(AllowedSenders, a_name_without_an_address_is_said) {
  try {
    const AllowedSenders none({"no host has spaces"});
    FAIL() << "was taken";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("who is no host has spaces?"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace odas::allowed_senders_test
