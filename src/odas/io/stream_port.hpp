// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "odas/io/file_descriptor.hpp"
#include "odas/io/tcp_dialer.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas {

/// Where a stream of samples comes in. Never waits.
class StreamPort {
 public:
  virtual ~StreamPort() = default;

  /// For messages: "127.0.0.1:9000".
  [[nodiscard]] virtual std::string where() const = 0;
  /// One step further: a stream, when there is one. What a user should know is appended to `notice`.
  [[nodiscard]] virtual std::optional<FileDescriptor> poll(std::string& notice) = 0;
  /// The same while a stream is running: others are turned away.
  virtual void refuse_others(std::string& notice) { static_cast<void>(notice); }
  /// Whether another stream may follow one that has ended.
  [[nodiscard]] virtual bool can_return() const noexcept { return true; }
};

/// We dial, as ODAS does, until somebody answers.
class DialPort : public StreamPort {
 public:
  DialPort(std::string host, int port) : dialer_(std::move(host), port) {}

  [[nodiscard]] std::string where() const override { return dialer_.where(); }
  [[nodiscard]] std::optional<FileDescriptor> poll(std::string& notice) override;

 private:
  TcpDialer dialer_;
  bool said_ = false;
};

/// Senders dial us: one at a time, the first with the token.
class ListenPort : public StreamPort {
 public:
  /// Throws IoError where the port cannot be had.
  ListenPort(const std::string& host, int port, std::string token);

  [[nodiscard]] std::string where() const override { return listener_.where(); }
  [[nodiscard]] int port() const noexcept { return listener_.port(); }
  [[nodiscard]] std::optional<FileDescriptor> poll(std::string& notice) override;
  void refuse_others(std::string& notice) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Candidate {
    TcpClient client;
    TokenGate gate;
    Clock::time_point until;  // his patience ends with ours
  };
  /// True: it can be forgotten.
  [[nodiscard]] static bool hear(Candidate& candidate);

  TcpListener listener_;
  std::string token_;
  std::vector<Candidate> candidates_;
  bool said_ = false;
  bool said_busy_ = false;
};

/// Standard input.
class StdinPort : public StreamPort {
 public:
  /// Throws IoError where it is a terminal.
  StdinPort();

  [[nodiscard]] std::string where() const override { return "standard input"; }
  [[nodiscard]] std::optional<FileDescriptor> poll(std::string& notice) override;
  [[nodiscard]] bool can_return() const noexcept override { return false; }

 private:
  FileDescriptor input_;
};

}  // namespace odas
