// SPDX-License-Identifier: MIT
#include "odas/io/target_server.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <list>
#include <optional>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/eventfd.h>

#include "odas/io/target_reader.hpp"
#include "odas/io/tcp_dialer.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas {
namespace {

constexpr int kPeriodMs = 100;  // of retries, and of looking at the engine
constexpr std::size_t kMostClients = 16;

}  // namespace

std::string to_json(const TargetList& targets) {
  nlohmann::json list = nlohmann::json::array();
  for (const Target& target : targets.view()) {
    const auto [x, y, z] = target.direction;
    list.push_back({{"tag", target.tag.view()}, {"x", x}, {"y", y}, {"z", z}});
  }
  // A tag of the configuration file may be cut within a letter: then that letter is replaced.
  return nlohmann::json{{"targets", list}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n";
}

class TargetServer::Server {
 public:
  Server(const InterfaceConfig& at, TargetInbox& inbox, std::function<void(const std::string&)> say)
      : token_(at.token), inbox_(inbox), say_(std::move(say)), wake_(::eventfd(0, EFD_CLOEXEC)) {
    if (at.type == "socket") {
      dialer_.emplace(at.ip, at.port);
    } else {
      listener_.emplace(at.ip, at.port);
    }
    thread_ = std::thread([this] { serve(); });
  }
  ~Server() {
    stop_ = true;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(wake_.get(), &one, sizeof one);
    thread_.join();
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::string where() const { return listener_ ? listener_->where() : dialer_->where(); }
  [[nodiscard]] int port() const { return listener_ ? listener_->port() : 0; }

 private:
  struct Client {
    Client(FileDescriptor s, std::string f, const std::string& token)
        : socket(std::move(s)), from(std::move(f)), gate(token) {}
    FileDescriptor socket;
    std::string from;
    TokenGate gate;
    TargetReader reader;
  };

  void serve() {
    while (!stop_) {
      wait();
      admit();
      for (auto client = clients_.begin(); client != clients_.end();) {
        client = read(*client) ? std::next(client) : clients_.erase(client);
      }
      inbox_.retry();
      tell_unfollowed();
    }
  }

  void wait() const {
    std::vector<pollfd> asked{{wake_.get(), POLLIN, 0}};
    if (listener_) asked.push_back({listener_->descriptor(), POLLIN, 0});
    for (const Client& client : clients_) asked.push_back({client.socket.get(), POLLIN, 0});
    ::poll(asked.data(), asked.size(), kPeriodMs);
  }

  void admit() {
    if (dialer_ && clients_.empty()) {
      if (auto socket = dialer_->poll()) clients_.emplace_back(std::move(*socket), dialer_->where(), "");
    }
    while (listener_) {
      std::optional<TcpClient> client = listener_->accept();
      if (!client) break;
      // Who has been silent longest goes: a forgotten client must not lock the others out.
      if (clients_.size() == kMostClients) clients_.pop_front();
      clients_.emplace_back(std::move(client->socket), std::move(client->from), token_);
    }
  }

  /// False: the client has gone, or has to go.
  bool read(Client& client) {
    std::array<char, 4096> piece{};
    for (;;) {
      const ssize_t count = ::recv(client.socket.get(), piece.data(), piece.size(), 0);
      if (count < 0) return errno == EAGAIN || errno == EINTR;
      if (count == 0) return false;
      std::string_view bytes(piece.data(), static_cast<std::size_t>(count));
      std::size_t used = 0;
      const TokenGate::State state = client.gate.push(bytes, used);
      if (state == TokenGate::State::refused) {
        say_("a client from " + client.from + " did not give the token first, and was sent away");
        answer(client, error_text("the first line must be the token"));
        return false;
      }
      if (state == TokenGate::State::waiting) continue;
      client.reader.push(bytes.substr(used));
      while (const std::optional<TargetMessage> message = client.reader.next())
        heed_message(client, *message);
    }
  }

  void heed_message(const Client& client, const TargetMessage& message) {
    if (!message.is_good()) {
      say_("a message from " + client.from + " " + message.fault + "; it changes nothing");
      answer(client, error_text(message.fault));
      return;
    }
    std::size_t surplus = 0;
    TargetList now;
    inbox_.change(
        [&](TargetInbox::Orders& orders) { now = orders.targets = heed(message, orders.targets, surplus); });
    if (surplus > 0) {
      const std::string fault = std::to_string(surplus) +
                                " targets too many: " + std::to_string(TargetList::kCapacity) +
                                " are the most";
      say_(fault);
      answer(client, error_text(fault));
    } else {
      answer(client, to_json(now));
    }
  }

  static std::string error_text(const std::string& fault) {
    return nlohmann::json{{"error", fault}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
           "\n";
  }

  /// Who does not read his answers loses them.
  static void answer(const Client& client, const std::string& text) {
    [[maybe_unused]] const auto sent = ::send(client.socket.get(), text.data(), text.size(), MSG_NOSIGNAL);
  }

  void tell_unfollowed() {
    const std::size_t now = inbox_.unfollowed();
    if (now == unfollowed_) return;
    unfollowed_ = now;
    if (now > 0) say_(std::to_string(now) + " targets are not followed: every slot is taken (sst.nTracks)");
  }

  std::string token_;
  TargetInbox& inbox_;
  std::function<void(const std::string&)> say_;
  std::optional<TcpListener> listener_;
  std::optional<TcpDialer> dialer_;
  std::list<Client> clients_;
  std::size_t unfollowed_ = 0;
  FileDescriptor wake_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

TargetServer::TargetServer(const InterfaceConfig& at, TargetInbox& inbox,
                           std::function<void(const std::string&)> say)
    : server_(std::make_unique<Server>(at, inbox, std::move(say))) {}
TargetServer::~TargetServer() = default;
std::string TargetServer::where() const { return server_->where(); }
int TargetServer::port() const { return server_->port(); }

}  // namespace odas
