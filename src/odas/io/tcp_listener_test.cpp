// SPDX-License-Identifier: MIT
#include "odas/io/tcp_listener.hpp"

#include "support/net_peer.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/io/tcp_dialer.hpp"

namespace odas::tcp_listener_test {
namespace {

using test::eventually;

/// Containers often have no IPv6.
bool has_ipv6() {
  try {
    const TcpListener trial("::1", 0);
    return true;
  } catch (const IoError&) { return false; }
}

TEST(TcpListener, a_dialler_reaches_a_listener_by_number_name_and_ipv6) {
  for (const auto& [at, to] :
       {std::pair{"", "localhost"}, std::pair{"127.0.0.1", "127.0.0.1"}, std::pair{"::1", "::1"}}) {
    if (std::string(at) == "::1" && !has_ipv6()) continue;
    TcpListener listener(at, 0);
    TcpDialer dialer(to, listener.port());
    std::optional<FileDescriptor> near;
    std::optional<TcpClient> far;
    ASSERT_TRUE(eventually([&] { return (near = dialer.poll()).has_value(); })) << dialer.fault();
    ASSERT_TRUE(eventually([&] { return (far = listener.accept()).has_value(); }));
    ASSERT_EQ(::send(near->get(), "abc", 3, MSG_NOSIGNAL), 3);
    char got[4] = {};
    ASSERT_TRUE(eventually([&] { return ::recv(far->socket.get(), got, 3, 0) == 3; }));
    EXPECT_STREQ(got, "abc");
    EXPECT_EQ(dialer.fault(), "");
    EXPECT_NE(far->from, "?");
  }
}

TEST(TcpListener, says_who_else_may_have_the_port) {
  const TcpListener first("", 0);
  try {
    const TcpListener second("", first.port());
    FAIL() << "two listeners at one port";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("another program listens there"), std::string::npos)
        << error.what();
  }
}

TEST(TcpListener, an_address_of_another_machine_is_refused_with_advice) {
  try {
    const TcpListener listener("192.0.2.1", 0);
    FAIL() << "listens at an address that is not ours";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("no address of this machine"), std::string::npos)
        << error.what();
  }
}

TEST(TokenGate, opens_at_the_token_and_leaves_what_comes_after_it) {
  TokenGate gate("s3cret");
  std::size_t used = 0;
  EXPECT_EQ(gate.push("s3c", used), TokenGate::State::waiting);
  EXPECT_EQ(gate.push("ret\r\n{\"x\"", used), TokenGate::State::granted);
  EXPECT_EQ(used, 5U);
  EXPECT_EQ(gate.push("more", used), TokenGate::State::granted);
  EXPECT_EQ(used, 0U);
}

TEST(TokenGate, stays_shut_for_any_other_line) {
  for (const char* line :
       {"\n", "s3cre\n", "s3cret1\n", "S3cret\n", "GET / HTTP/1.1\r\n", "s3cret no line feed"}) {
    TokenGate gate("s3cret");
    std::size_t used = 0;
    EXPECT_EQ(gate.push(line, used), TokenGate::State::refused) << line;
    EXPECT_EQ(gate.push("s3cret\n", used), TokenGate::State::refused) << line;
  }
}

TEST(TokenGate, without_a_token_everybody_is_let_in) {
  EXPECT_EQ(TokenGate("").state(), TokenGate::State::granted);
}

}  // namespace
}  // namespace odas::tcp_listener_test
