// SPDX-License-Identifier: MIT
#include "odas/base/host.hpp"

#include <gtest/gtest.h>

namespace odas::host_test {
namespace {

TEST(Host, this_machine_alone_is_loopback) {
  for (const char* host : {"", "localhost", "127.0.0.1", "127.1.2.3", "::1"}) {
    EXPECT_TRUE(is_loopback_host(host)) << host;
  }
  for (const char* host : {"0.0.0.0", "::", "192.168.0.7", "robot.local", "127.example.org", "1270.0.0.1"}) {
    EXPECT_FALSE(is_loopback_host(host)) << host;
  }
}

}  // namespace
}  // namespace odas::host_test
