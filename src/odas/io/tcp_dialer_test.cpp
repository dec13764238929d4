// SPDX-License-Identifier: MIT
#include "odas/io/tcp_dialer.hpp"

#include "support/net_peer.hpp"
#include <gtest/gtest.h>

#include "odas/io/tcp_listener.hpp"

namespace odas::tcp_dialer_test {
namespace {

using test::eventually;

TEST(TcpDialer, tries_again_after_pauses_that_grow_until_the_peer_is_there) {
  int port = 0;
  { port = TcpListener("", 0).port(); }  // free again
  TcpDialer dialer("127.0.0.1", port);
  auto now = TcpDialer::Clock::now();
  ASSERT_TRUE(eventually([&] { return !dialer.poll(now) && !dialer.fault().empty(); }));
  EXPECT_NE(dialer.fault().find("refused"), std::string::npos) << dialer.fault();

  TcpListener listener("", port);
  EXPECT_FALSE(dialer.poll(now)) << "it pauses";
  EXPECT_FALSE(listener.accept());
  now += TcpDialer::kFirstPause;
  EXPECT_TRUE(eventually([&] { return dialer.poll(now).has_value(); }));
  EXPECT_EQ(dialer.fault(), "");
  EXPECT_FALSE(dialer.poll(now)) << "one that is lost at once is not dialled at once again";
}

TEST(TcpDialer, a_host_that_is_not_known_is_a_fault_and_no_end) {
  TcpDialer dialer("no such host", 9000);
  ASSERT_TRUE(eventually([&] { return !dialer.poll() && !dialer.fault().empty(); }));
  EXPECT_NE(dialer.fault().find("not known"), std::string::npos) << dialer.fault();
}

}  // namespace
}  // namespace odas::tcp_dialer_test
