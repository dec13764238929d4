// SPDX-License-Identifier: MIT
#include "odas/io/stream_port.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "odas/base/error.hpp"

namespace odas::stream_port_test {
namespace {

/// Polls until there is a stream, or a notice with this text.
std::optional<FileDescriptor> poll(StreamPort& port, std::string& notices, const std::string& until = "\1") {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < deadline) {
    if (auto stream = port.poll(notices)) return stream;
    if (notices.find(until) != std::string::npos) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ADD_FAILURE() << "nothing has come; notices: " << notices;
  return std::nullopt;
}

FileDescriptor dial(int port, const std::string& host = "127.0.0.1") {
  DialPort dialer(host, port);
  std::string notices;
  auto stream = poll(dialer, notices);
  return stream ? std::move(*stream) : FileDescriptor();
}

void send(const FileDescriptor& to, const std::string& bytes) {
  ASSERT_EQ(::write(to.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

std::string receive(const FileDescriptor& from, std::size_t bytes) {
  std::string text(bytes, ' ');
  std::size_t got = 0;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (got < bytes && std::chrono::steady_clock::now() < deadline) {
    const ssize_t n = ::read(from.get(), text.data() + got, bytes - got);
    if (n == 0) break;
    if (n > 0) got += static_cast<std::size_t>(n);
  }
  text.resize(got);
  return text;
}

TEST(DialPort, says_once_that_it_waits_and_that_it_is_connected) {
  int number = 0;
  {
    const TcpListener closed("", 0);
    number = closed.port();
  }
  DialPort port("127.0.0.1", number);
  std::string notices;
  EXPECT_FALSE(poll(port, notices, "cannot reach 127.0.0.1:" + std::to_string(number) + " yet"));
  const std::string first = notices;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(port.poll(notices));
  EXPECT_EQ(notices, first);
  TcpListener listener("", number);
  EXPECT_TRUE(poll(port, notices));
  EXPECT_NE(notices.find("connected to 127.0.0.1"), std::string::npos);
}

TEST(ListenPort, takes_one_sender_at_a_time) {
  ListenPort port("", 0, "");
  std::string notices;
  EXPECT_FALSE(port.poll(notices));
  EXPECT_EQ(notices, "waiting for a sender at " + port.where());
  const FileDescriptor sender = dial(port.port());
  const auto stream = poll(port, notices);
  ASSERT_TRUE(stream);
  EXPECT_NE(notices.find("receiving from 127.0.0.1:"), std::string::npos);
  const FileDescriptor other = dial(port.port());
  std::string busy;
  for (int i = 0; i < 2000 && busy.empty(); ++i) {
    port.refuse_others(busy);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_NE(busy.find("there is a sender already"), std::string::npos);
  EXPECT_EQ(receive(other, 1), "") << "he is told so";
  send(sender, "sound");
  EXPECT_EQ(receive(*stream, 5), "sound");
}

TEST(ListenPort, lets_in_who_has_the_token_and_hands_on_what_follows_it) {
  ListenPort port("127.0.0.1", 0, "secret");
  std::string notices;
  const FileDescriptor stranger = dial(port.port());
  send(stranger, "noise, noise, noise\n");
  EXPECT_FALSE(poll(port, notices, "it did not begin with the token"));
  const FileDescriptor silent = dial(port.port());
  const FileDescriptor sender = dial(port.port());
  send(sender, "secr");
  EXPECT_FALSE(port.poll(notices));
  send(sender, "et\nsound");
  const auto stream = poll(port, notices);
  ASSERT_TRUE(stream) << "though another one is silent";
  EXPECT_EQ(receive(*stream, 5), "sound");
}

TEST(ListenPort, is_reached_by_its_name_too) {
  ListenPort port("localhost", 0, "");
  std::string notices;
  const FileDescriptor sender = dial(port.port(), "localhost");
  EXPECT_TRUE(poll(port, notices)) << notices;
}

TEST(ListenPort, listens_at_addresses_of_both_kinds) {
  try {
    ListenPort port("::1", 0, "");
    std::string notices;
    const FileDescriptor sender = dial(port.port(), "::1");
    EXPECT_TRUE(poll(port, notices));
    EXPECT_NE(notices.find("receiving from [::1]:"), std::string::npos);
  } catch (const IoError& error) { GTEST_SKIP() << "no IPv6 here: " << error.what(); }
}

}  // namespace
}  // namespace odas::stream_port_test
