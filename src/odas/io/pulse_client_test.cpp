// SPDX-License-Identifier: MIT
#include "odas/io/pulse_client.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

namespace odas::pulse_client_test {
namespace {

// With a server it is tested in tests/capture_test.cpp.
TEST(PulseClient, says_that_there_is_no_server) {
  ::setenv("PULSE_SERVER", "unix:/no/such/socket", 1);
  PulseClient client;
  EXPECT_EQ(client.connect(PulseClient::Clock::now() + std::chrono::seconds(5), false), "Connection refused");
  EXPECT_FALSE(client.good());
  EXPECT_FALSE(client.source("mic", PulseClient::Clock::now()));
  EXPECT_TRUE(client.sources(PulseClient::Clock::now()).empty());
}

}  // namespace
}  // namespace odas::pulse_client_test
