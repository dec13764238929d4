// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "odas/io/file_descriptor.hpp"
#include "odas/io/net_address.hpp"

namespace odas {

/// Dials a peer until he answers: never waits, and tries again for ever, after 100 ms at first and after 3 s
/// at most. A name is looked up anew each time; all its addresses are tried in turn.
///
///     if (auto socket = dialer.poll()) ...   // connected; poll again once it is lost
class TcpDialer {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kFirstPause{100}, kLongestPause{3000}, kPatience{5000};

  TcpDialer(std::string host, int port) : host_(std::move(host)), port_(port) {}

  /// One step further. The socket, when the peer has answered: it does not block, and sends without delay.
  [[nodiscard]] std::optional<FileDescriptor> poll(Clock::time_point now = Clock::now());

  /// "robot:9000".
  [[nodiscard]] std::string where() const { return host_and_port(host_, port_); }
  /// Why the last attempt failed; "" while none has, or since one succeeded.
  [[nodiscard]] const std::string& fault() const noexcept { return fault_; }

 private:
  void begin_next(Clock::time_point now);
  void fail(const std::string& why, Clock::time_point now);
  [[nodiscard]] std::optional<FileDescriptor> finish(Clock::time_point now);

  std::string host_;
  int port_;
  Clock::time_point next_{};  // no attempt before this
  Clock::duration pause_ = kFirstPause;
  std::optional<NameLookup> lookup_;
  std::vector<NetAddress> untried_;  // the next one last
  FileDescriptor dialling_;          // on its way
  Clock::time_point began_{};
  std::string fault_;
};

}  // namespace odas
