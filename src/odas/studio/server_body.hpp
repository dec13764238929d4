// SPDX-License-Identifier: MIT
// The inside of StudioServer, for its sessions. What is to be sent is decided elsewhere: by Gate, assets,
// FileProvider, ClientFeed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>  // before Boost 1.74, which forgets it
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "odas/studio/client_hall.hpp"
#include "odas/studio/gate.hpp"
#include "odas/studio/rare_notes.hpp"
#include "odas/studio/server.hpp"
#include "odas/studio/work_queue.hpp"

namespace odas {

/// With a request, and with who takes nothing.
inline constexpr std::chrono::seconds kBrowserPatience{10};

class StudioServer::Body {
 public:
  using Tcp = boost::asio::ip::tcp;
  using Clock = ClientFeed::Clock;

  Body(const StudioConfig& config, const RpcRegistry& rpc, std::vector<FileProvider*> files,
       ServerHooks hooks);
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  [[nodiscard]] int port() const { return port_; }
  [[nodiscard]] std::string url() const;

  // For sessions, in the server's thread.
  void add(const std::shared_ptr<StudioClient>& client);
  void connection_ended() { --connections_; }
  void find_file(const std::string& path, const std::string& query,
                 const std::function<void(std::optional<Served>, const std::string& fault)>& then);
  void note(const std::string& kind, const std::string& text) {
    if (hooks_.say && notes_.is_due(kind, Clock::now())) hooks_.say(text);
  }
  [[nodiscard]] bool tls() const noexcept { return tls_.has_value(); }
  [[nodiscard]] const ServerHooks& hooks() const noexcept { return hooks_; }
  [[nodiscard]] const std::string& content_policy() const noexcept { return content_policy_; }

 private:
  StudioConfig config_;
  ServerHooks hooks_;
  std::vector<FileProvider*> files_;
  std::string content_policy_;
  boost::asio::io_context io_{1};

 public:
  Gate gate;
  HopRing ring;

 private:
  void listen();
  void accept();
  void admit(Tcp::socket socket);
  void start_ticking();
  void tick();

  std::optional<boost::asio::ssl::context> tls_;
  Tcp::acceptor acceptor_{io_};
  boost::asio::steady_timer retry_{io_}, ticker_{io_};
  int port_ = 0;
  std::size_t connections_ = 0;
  bool ticking_ = false;
  RareNotes notes_;
  WorkQueue commands_;

 public:
  ClientHall hall;

 private:
  std::thread thread_;
};

}  // namespace odas
