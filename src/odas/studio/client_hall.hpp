// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "odas/studio/client_feed.hpp"
#include "odas/studio/rpc.hpp"
#include "odas/studio/server.hpp"
#include "odas/studio/work_queue.hpp"

namespace odas {

/// A client's connection, whatever it is made of.
class StudioClient {
 public:
  StudioClient(const HopRing& ring, std::function<std::string(std::uint64_t)> health, Role its_role)
      : feed(ring, std::move(health)), role(its_role) {}
  virtual ~StudioClient() = default;
  /// Sends what is due, unless something is on its way.
  virtual void wake(ClientFeed::Clock::time_point now) = 0;

  ClientFeed feed;
  Role role;
  int commands = 0;  // on their way
};

/// All clients, and what is said between them and the rest of the Studio. Everything happens in the server's
/// thread, but for `announce` and `greet_anew`, which come from any; commands are carried out in `commands`.
class ClientHall {
 public:
  /// `post` runs something in the server's thread, soon.
  using Post = std::function<void(std::function<void()>)>;
  ClientHall(HopRing& ring, const RpcRegistry& rpc, WorkQueue& commands, const ServerHooks& hooks, Post post);

  void add(const std::shared_ptr<StudioClient>& client);
  void remove(const StudioClient& client);
  /// What a client has said.
  void hear(const std::shared_ptr<StudioClient>& client, std::string_view text);
  void wake_all(ClientFeed::Clock::time_point now);
  [[nodiscard]] std::size_t size() const noexcept { return clients_.size(); }

  /// To all who want the topic. Newcomers are told the last of each type, and of the log the last lines.
  void announce(const std::string& topic, const nlohmann::json& message);
  /// The run is another one: `hello` again.
  void greet_anew();

  /// Messages that are asked for by HTTP, too.
  [[nodiscard]] nlohmann::json hello(Role role) const;
  [[nodiscard]] std::string health(std::uint64_t lost) const;
  /// `health`, and `beams` of the message of that name.
  [[nodiscard]] nlohmann::json figures() const;

 private:
  using Client = std::shared_ptr<StudioClient>;
  void subscribe(const Client& client, const nlohmann::json& message);
  void command(const Client& client, const nlohmann::json& message);
  void tell(const Client& client, const nlohmann::json& message, bool may_be_lost) const;
  void remember(const std::string& topic, const nlohmann::json& message);
  void tell_known(const Client& client, const std::string& topic) const;
  void update_demand();
  [[nodiscard]] nlohmann::json health_message(std::uint64_t lost) const;

  static constexpr int kMostCommands = 32;       // of a client, that wait to be carried out
  static constexpr std::size_t kLogLines = 200;  // that newcomers are told

  HopRing& ring_;
  const RpcRegistry& rpc_;
  WorkQueue& commands_;
  const ServerHooks& hooks_;
  Post post_;
  std::list<Client> clients_;
  std::map<std::string, nlohmann::json> known_;  // by type: the last message
  nlohmann::json log_ = nlohmann::json::array();
};

}  // namespace odas
