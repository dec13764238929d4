// SPDX-License-Identifier: MIT
// Peers of the network writers and readers: who connect, read, stall and go as a test wants it.
#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include "odas/io/tcp_dialer.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas::test {

/// Steps until `done`, or for a long time.
template <class Done>
bool eventually(Done&& done) {
  for (int i = 0; i < 2000; ++i) {
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

/// A connection to a listener of this machine.
inline FileDescriptor connect_to(int port) {
  TcpDialer dialer("127.0.0.1", port);
  std::optional<FileDescriptor> socket;
  EXPECT_TRUE(eventually([&] { return (socket = dialer.poll()).has_value(); })) << dialer.fault();
  return socket ? std::move(*socket) : FileDescriptor();
}

/// Who comes to a listener next.
inline FileDescriptor accept_from(TcpListener& listener) {
  std::optional<TcpClient> client;
  EXPECT_TRUE(eventually([&] { return (client = listener.accept()).has_value(); }));
  return client ? std::move(client->socket) : FileDescriptor();
}

/// What has come so far.
inline std::string read_now(const FileDescriptor& socket) {
  std::string got;
  std::array<char, 65536> piece{};
  for (ssize_t n = 0; (n = ::recv(socket.get(), piece.data(), piece.size(), MSG_DONTWAIT)) > 0;) {
    got.append(piece.data(), static_cast<std::size_t>(n));
  }
  return got;
}

/// What comes until the peer has said his last, or nothing has come for ten seconds.
inline std::string read_all(const FileDescriptor& socket) {
  std::string got;
  std::array<char, 65536> piece{};
  pollfd asked{socket.get(), POLLIN, 0};
  while (::poll(&asked, 1, 10000) > 0) {
    const ssize_t n = ::recv(socket.get(), piece.data(), piece.size(), 0);
    if (n <= 0) break;
    got.append(piece.data(), static_cast<std::size_t>(n));
  }
  return got;
}

}  // namespace odas::test
