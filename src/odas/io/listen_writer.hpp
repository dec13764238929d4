// SPDX-License-Identifier: MIT
#pragma once

#include <list>

#include "odas/io/byte_writer.hpp"
#include "odas/io/peer_link.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas {

/// Records to whoever connects: `type = "socket_listen"`. Each client gets whole records from the moment he
/// is let in; one who does not read loses whole records, and none of the others notices.
class ListenWriter : public ByteWriter {
 public:
  static constexpr std::size_t kMostClients = 32;

  /// `token`: what clients say first; "": they need not. Throws IoError where it cannot listen.
  ListenWriter(const std::string& host, int port, std::string token, PeerManners manners);

  [[nodiscard]] std::string where() const override { return listener_.where(); }
  [[nodiscard]] int port() const noexcept { return listener_.port(); }
  IoStatus write(std::span<const char> record) override;
  IoStatus flush() override;
  IoStatus close() override;
  [[nodiscard]] std::uint64_t lost_records() const noexcept override;

 private:
  struct Client {
    PeerLink link;
    TokenGate gate;
    std::string from;
    std::uint64_t behind = 0;
  };

  void admit();
  /// Reads what he says until he is let in. False: he has to go.
  bool let_in(Client& client) const;
  void put(Client& client, std::span<const char> record);
  void send_all();
  void say(const std::string& what) const;

  TcpListener listener_;
  std::string token_;
  PeerManners manners_;
  std::list<Client> clients_;
  std::uint64_t lost_ = 0;  // of clients who have gone
};

}  // namespace odas
