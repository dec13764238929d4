// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odas/io/byte_writer.hpp"
#include "odas/io/file_descriptor.hpp"
#include "odas/io/net_address.hpp"

namespace odas {

/// Records as datagrams, one each: `type = "udp"`. Whether somebody hears them is not known; those that could
/// not even be sent are lost, and counted. Where a name has several addresses and one of them refuses, the
/// next one is tried.
class UdpWriter : public ByteWriter {
 public:
  /// The most that a datagram holds (IPv4).
  static constexpr std::size_t kLongest = 65507;

  /// `say` is told once why datagrams cannot be sent. May be empty.
  UdpWriter(std::string host, int port, std::function<void(const std::string&)> say);
  /// To a peer whose addresses are known already.
  UdpWriter(std::string host, std::vector<NetAddress> addresses, std::function<void(const std::string&)> say);

  [[nodiscard]] std::string where() const override { return "udp " + host_and_port(host_, port_); }
  IoStatus write(std::span<const char> record) override;
  IoStatus flush() override { return {}; }
  IoStatus close() override { return {}; }
  [[nodiscard]] std::uint64_t lost_records() const noexcept override { return lost_; }

 private:
  void find_peer();
  void connect_first();
  void connect_next();
  void tell_once(const std::string& why);

  std::string host_;
  int port_;
  std::function<void(const std::string&)> say_;
  std::optional<NameLookup> lookup_;
  std::chrono::steady_clock::time_point next_lookup_{};
  std::vector<NetAddress> addresses_;  // of the peer, once they are known
  std::size_t next_ = 0;               // which of them is tried next
  FileDescriptor socket_;              // connected to one of them
  std::uint64_t lost_ = 0;
  bool told_ = false;
};

}  // namespace odas
