// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odas/engine/config.hpp"
#include "odas/engine/target_inbox.hpp"

namespace odas {

/// Takes fixed directions from clients while a run goes on: `sst.control`. docs/protocol.md has the messages.
///
/// A thread of its own listens (socket_listen) or dials (socket), reads messages of any client, hands good
/// ones to the engine, and answers each: `{"targets":[...]}`, those that hold now, or `{"error":"..."}`. The
/// last message wins, whoever sent it; targets stay when their sender goes.
class TargetServer {
 public:
  /// `say` is called in the server's thread: who spoke nonsense,
  /// targets that find no slot. Throws IoError where it cannot listen.
  TargetServer(const InterfaceConfig& at, TargetInbox& inbox, std::function<void(const std::string&)> say);
  ~TargetServer();
  TargetServer(const TargetServer&) = delete;
  TargetServer& operator=(const TargetServer&) = delete;

  /// Where it listens, or whom it dials: "127.0.0.1:9010".
  [[nodiscard]] std::string where() const;
  /// The port it listens at.
  [[nodiscard]] int port() const;

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

/// What every client is answered: `{"targets":[{"tag":"a","x":1.000000,...}]}` and a line feed.
[[nodiscard]] std::string to_json(const TargetList& targets);

}  // namespace odas
