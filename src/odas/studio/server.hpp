// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "odas/engine/studio_config.hpp"
#include "odas/studio/hop_listener.hpp"
#include "odas/studio/messages.hpp"
#include "odas/studio/rpc.hpp"
#include "odas/studio/served.hpp"

namespace odas {

/// What the server asks others for. In the server's thread, so without waiting; each may be empty.
struct ServerHooks {
  /// The figures of `health`, but for those of the server itself.
  std::function<nlohmann::json()> health{};
  /// What `hello` says beyond `run`: `recordings`, `open_session`, `camera`; and `targets`, which goes into
  /// `run`.
  std::function<nlohmann::json()> hello{};
  /// Why the engine does not run, for /healthz; "": it does, or waits for its source.
  std::function<std::string()> failure{};
  /// Who was turned away, and why. Rare: each kind once a minute.
  std::function<void(const std::string&)> say{};
};

/// The page, files and the WebSocket of the Studio, on one port: docs/protocol.md.
///
/// Two threads: one serves all clients, one carries out commands, one after another. Neither ever holds up
/// who calls `hop` or `announce`. A client who takes nothing for ten seconds is let go.
class StudioServer final : public HopListener, public Announcer {
 public:
  static constexpr std::size_t kMostClients = 256;       // WebSockets
  static constexpr std::size_t kMostConnections = 1024;  // of all kinds

  /// Listens at once. Throws ConfigError (address without a token, TLS files) and IoError (port in use).
  /// `rpc` and `files` outlive it.
  StudioServer(const StudioConfig& config, RpcRegistry& rpc, std::vector<FileProvider*> files,
               ServerHooks hooks);
  ~StudioServer() override;

  void begin(const StreamInfo& info) override;
  void hop(const HopResult& hop) override;
  void end() override;
  void announce(const std::string& topic, const nlohmann::json& message) override;

  [[nodiscard]] int port() const;
  /// "http://127.0.0.1:8080/", with the operators' token where one is needed.
  [[nodiscard]] std::string url() const;

  class Body;  // server_body.hpp

 private:
  std::unique_ptr<Body> body_;
};

}  // namespace odas
