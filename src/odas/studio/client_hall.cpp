// SPDX-License-Identifier: MIT
#include "odas/studio/client_hall.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace odas {

using nlohmann::json;

namespace {

std::string text_of(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

json error_reply(const json& id, const RpcError& error) {
  return {{"type", "reply"},
          {"id", id},
          {"error", {{"code", error.code()}, {"message", error.what()}, {"data", error.data()}}}};
}

/// Of which a newcomer is told the last one, as if he had been here.
bool is_state(const json& message) {
  static const std::set<std::string> kStates{"engine", "recordings", "targets"};
  return kStates.contains(message.value("type", ""));
}

}  // namespace

ClientHall::ClientHall(HopRing& ring, const RpcRegistry& rpc, WorkQueue& commands, const ServerHooks& hooks,
                       Post post)
    : ring_(ring), rpc_(rpc), commands_(commands), hooks_(hooks), post_(std::move(post)) {}

void ClientHall::add(const Client& client) {
  clients_.push_back(client);
  tell(client, hello(client->role), false);
  if (known_.contains("engine")) tell(client, known_.at("engine"), false);
}

void ClientHall::remove(const StudioClient& client) {
  clients_.remove_if([&](const Client& one) { return one.get() == &client; });
  update_demand();
}

void ClientHall::wake_all(ClientFeed::Clock::time_point now) {
  // A client may leave while he is woken.
  const std::vector<Client> all(clients_.begin(), clients_.end());
  for (const Client& client : all) client->wake(now);
}

void ClientHall::hear(const Client& client, std::string_view text) {
  const json message = json::parse(text, nullptr, false);
  json id = nullptr;
  try {
    if (!message.is_object()) throw RpcError("bad_request", "a message is a JSON object");
    id = message.value("id", json());
    const std::string type = message.value("type", "");
    if (message.contains("method")) {
      command(client, message);
    } else if (type == "subscribe") {
      subscribe(client, message);
    } else if (type == "ping") {
      tell(client, {{"type", "pong"}, {"at", message.value("at", json())}}, true);
    }
  } catch (const RpcError& error) {
    tell(client, error_reply(id, error), false);
  } catch (const json::exception& e) {
    tell(client, error_reply(id, RpcError("bad_request", e.what())), false);
  }
  client->wake(ClientFeed::Clock::now());
}

void ClientHall::subscribe(const Client& client, const json& message) {
  const auto before = client->feed.subscription().topics;
  client->feed.subscribe(read_subscription(message), ClientFeed::Clock::now());
  for (const auto& [topic, rate] : client->feed.subscription().topics) {
    if (!before.contains(topic)) tell_known(client, topic);
  }
  update_demand();
}

void ClientHall::tell_known(const Client& client, const std::string& topic) const {
  if (topic == "log" && !log_.empty()) tell(client, {{"type", "log"}, {"lines", log_}}, true);
  if (const auto found = known_.find(topic); found != known_.end()) tell(client, found->second, true);
}

void ClientHall::command(const Client& client, const json& message) {
  const json id = message.value("id", json());
  const std::string method = message.at("method");
  if (client->commands >= kMostCommands) {
    throw RpcError("failed", "too many commands are waiting; wait for their answers");
  }
  ++client->commands;
  commands_.add([this, who = std::weak_ptr(client), role = client->role, id, method,
                 params = message.value("params", json::object())] {
    json reply;
    try {
      reply = {{"type", "reply"}, {"id", id}, {"result", rpc_.call(method, params, role)}};
    } catch (const RpcError& error) { reply = error_reply(id, error); }
    post_([this, who, reply = std::move(reply)] {
      const Client asker = who.lock();
      if (!asker) return;
      --asker->commands;
      tell(asker, reply, false);
      asker->wake(ClientFeed::Clock::now());
    });
  });
}

void ClientHall::tell(const Client& client, const json& message, bool may_be_lost) const {
  client->feed.put(std::make_shared<const std::string>(text_of(message)), may_be_lost);
}

void ClientHall::announce(const std::string& topic, const json& message) {
  post_([this, topic, message] {
    remember(topic, message);
    const auto text = std::make_shared<const std::string>(text_of(message));
    for (const Client& client : clients_) {
      if (topic.empty() || client->feed.subscription().rate_of(topic) > 0) client->feed.put(text, true);
    }
    wake_all(ClientFeed::Clock::now());
  });
}

void ClientHall::remember(const std::string& topic, const json& message) {
  if (is_state(message)) known_[message.at("type")] = message;
  if (topic != "log") return;
  for (const json& line : message.value("lines", json::array())) log_.push_back(line);
  while (log_.size() > kLogLines) log_.erase(log_.begin());
}

void ClientHall::greet_anew() {
  post_([this] {
    for (const Client& client : clients_) tell(client, hello(client->role), false);
    wake_all(ClientFeed::Clock::now());
  });
}

json ClientHall::hello(Role role) const {
  json message = hooks_.hello ? hooks_.hello() : json::object();
  json targets = message.value("targets", json::array());
  message.erase("targets");
  message["type"] = "hello";
  message["protocol"] = 1;
  message["server"] = "odas " ODAS_VERSION;
  message["role"] = role == Role::operator_ ? "operator" : "viewer";
  message["run"] = nullptr;
  if (const auto run = ring_.run()) {
    message["run"] = run_message(*run);
    message["run"]["targets"] = std::move(targets);
  }
  return message;
}

std::string ClientHall::health(std::uint64_t lost) const { return text_of(health_message(lost)); }

json ClientHall::figures() const {
  json all = health_message(0);
  all["beams"] = json::parse("[" + beams_text(ring_.beams()) + "]");
  return all;
}

json ClientHall::health_message(std::uint64_t lost) const {
  json message = hooks_.health ? hooks_.health() : json::object();
  message["type"] = "health";
  message["clients"] = clients_.size();
  message["client_dropped"] = lost;
  message["latency"] = nullptr;
  const auto run = ring_.run();
  if (const HopRing::Pulse pulse = ring_.pulse(); run && pulse.time > 0) {
    // From the end of the hop's sound to when it was here. Of a recording it says nothing.
    const std::chrono::duration<double> late = pulse.came - run->at(pulse.time + 1);
    if (run->kind != StreamInfo::Kind::recording) message["latency"] = std::max(0.0, late.count());
  }
  return message;
}

void ClientHall::update_demand() {
  HopRing::Demand demand;
  for (const Client& client : clients_) client->feed.subscription().add_to(demand);
  ring_.demand(demand);
}

}  // namespace odas
