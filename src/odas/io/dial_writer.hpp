// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "odas/io/byte_writer.hpp"
#include "odas/io/peer_link.hpp"
#include "odas/io/tcp_dialer.hpp"

namespace odas {

/// Records to one peer who listens, as ODAS sends them: `type = "socket"`. A peer who is not there is dialled
/// for ever; each connection begins with a whole record; what cannot be sent is lost, and counted.
class DialWriter : public ByteWriter {
 public:
  DialWriter(const std::string& host, int port, PeerManners manners);

  [[nodiscard]] std::string where() const override { return dialer_.where(); }
  IoStatus write(std::span<const char> record) override;
  IoStatus flush() override;
  IoStatus close() override;
  [[nodiscard]] std::uint64_t lost_records() const noexcept override;

 private:
  /// Dials, if need be, and sends.
  void step();
  void await_first_answer();
  void say(const std::string& what) const;

  TcpDialer dialer_;
  PeerManners manners_;
  std::optional<PeerLink> link_;
  std::uint64_t lost_ = 0;    // for want of a connection, or with one
  std::uint64_t absent_ = 0;  // records since the last connection
  std::uint64_t behind_ = 0;
  bool answered_ = false;  // ever, or has been waited for
  bool told_absent_ = false;
};

}  // namespace odas
