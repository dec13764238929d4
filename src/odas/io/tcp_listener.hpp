// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "odas/io/file_descriptor.hpp"
#include "odas/io/net_address.hpp"

namespace odas {

/// A client who has connected: his socket does not block, and sends without delay.
struct TcpClient {
  FileDescriptor socket;
  std::string from;  // "192.168.0.7:51234"
  NetAddress address{};
};

/// Waits for clients without waiting: `accept` gives who has come.
class TcpListener {
 public:
  /// `host`: a name or number of this machine; "" is 127.0.0.1. Port 0: the system chooses one. Throws
  /// IoError: the port is in use, needs privileges, or the address is not ours.
  TcpListener(const std::string& host, int port);

  /// The next client, if there is one.
  [[nodiscard]] std::optional<TcpClient> accept();

  [[nodiscard]] int port() const noexcept { return port_; }
  /// "127.0.0.1:9000".
  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  /// To wait for clients by poll().
  [[nodiscard]] int descriptor() const noexcept { return socket_.get(); }

 private:
  /// 0, or the errno of what failed.
  int listen_at(const NetAddress& address);

  FileDescriptor socket_;
  int port_ = 0;
  std::string where_;
};

/// What a client must say first, where a server is open to a network: the token, and a line feed. (With nc:
/// `(echo TOKEN; cat) | nc HOST PORT`.) How much of a wrong token was right cannot be told from the time.
class TokenGate {
 public:
  enum class State { waiting, granted, refused };

  /// "": everybody is let in.
  explicit TokenGate(std::string token);

  /// Takes what the client says. Bytes behind the token's line are not the gate's: `used` says how many were.
  State push(std::string_view bytes, std::size_t& used);
  [[nodiscard]] State state() const noexcept { return state_; }

 private:
  std::string token_;
  std::string line_;
  State state_;
};

}  // namespace odas
