// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/engine/signals_blocked.hpp"
#include "odas/studio/http_session.hpp"
#include "odas/studio/web_policy.hpp"

namespace odas {
namespace {

namespace asio = boost::asio;
using Error = boost::system::error_code;
using nlohmann::json;

constexpr auto kTick = std::chrono::microseconds(16667);

asio::ssl::context tls_of(const StudioConfig& config) {
  asio::ssl::context tls(asio::ssl::context::tls_server);
  tls.set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_tlsv1 |
                  asio::ssl::context::no_tlsv1_1);
  Error error;
  tls.use_certificate_chain_file(config.certificate, error);
  if (error) throw ConfigError("studio.certificate", config.certificate + ": " + error.message());
  tls.use_private_key_file(config.key, asio::ssl::context::pem, error);
  if (error) throw ConfigError("studio.key", config.key + ": " + error.message());
  return tls;
}

}  // namespace

StudioServer::Body::Body(const StudioConfig& config, const RpcRegistry& rpc, std::vector<FileProvider*> files,
                         ServerHooks hooks)
    : config_(config),
      hooks_(std::move(hooks)),
      files_(std::move(files)),
      content_policy_(odas::content_policy(config)),
      gate({(config_.token = operator_token(config)), config.viewer_token}, server_names(config),
           !config.certificate.empty()),
      hall(ring, rpc, commands_, hooks_,
           [this](std::function<void()> task) { asio::post(io_, std::move(task)); }) {
  if (!config.certificate.empty()) tls_.emplace(tls_of(config));
  listen();
  accept();
  const SignalsBlocked signals_blocked;
  thread_ = std::thread([this] { io_.run(); });
}

StudioServer::Body::~Body() {
  commands_.stop();
  io_.stop();
  thread_.join();
}

std::string StudioServer::Body::url() const {
  const std::string token = config_.token.empty() ? "" : "?token=" + config_.token;
  return fmt::format("{}://{}:{}/{}", tls() ? "https" : "http", link_host(config_), port_, token);
}

void StudioServer::Body::listen() {
  const std::string host = config_.ip.empty() ? "127.0.0.1" : config_.ip;
  Error error;
  Tcp::resolver resolver(io_);
  const auto found = resolver.resolve(host, std::to_string(config_.port), Tcp::resolver::passive, error);
  if (error || found.empty()) {
    throw ConfigError("studio.ip",
                      "'" + host + "' is no address to listen at; 127.0.0.1 is this machine alone");
  }
  const Tcp::endpoint endpoint = found.begin()->endpoint();
  const auto fail = [&](const std::string& hint) {
    throw IoError(fmt::format("cannot listen on {}:{}: {}{}", host, config_.port, error.message(), hint));
  };
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error == asio::error::address_in_use)
    fail("; another program is there: choose another port (--listen, or studio.port)");
  if (error == std::errc::address_not_available)
    fail("; this machine has other addresses; 0.0.0.0 is all of them");
  if (error == asio::error::access_denied) fail("; ports below 1024 need privileges: choose a higher one");
  if (error) fail("");
  port_ = acceptor_.local_endpoint().port();
}

void StudioServer::Body::accept() {
  acceptor_.async_accept([this](Error error, Tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (error) {  // no more files, for a while
      note("accept", "no more browsers can be let in for now: " + error.message());
      retry_.expires_after(std::chrono::milliseconds(200));
      retry_.async_wait([this](Error stopped) {
        if (!stopped) accept();
      });
      return;
    }
    if (connections_ < kMostConnections) {
      admit(std::move(socket));
    } else {
      note("connections", "more connections came than can be served");
    }
    accept();
  });
}

void StudioServer::Body::admit(Tcp::socket socket) {
  ++connections_;
  Error ignored;
  socket.set_option(Tcp::no_delay(true), ignored);
  WebStream::Plain plain(std::move(socket));
  start_http_session(tls_ ? WebStream(std::move(plain), *tls_) : WebStream(std::move(plain)), *this);
}

void StudioServer::Body::add(const std::shared_ptr<StudioClient>& client) {
  hall.add(client);
  client->wake(Clock::now());
  start_ticking();
}

void StudioServer::Body::start_ticking() {
  if (std::exchange(ticking_, true)) return;
  ticker_.expires_after(kTick);
  tick();
}

/// The clock of all clients; it stands still while there are none.
void StudioServer::Body::tick() {
  ticker_.async_wait([this](Error stopped) {
    if (stopped) return;
    const auto now = Clock::now();
    hall.wake_all(now);
    ticking_ = hall.size() > 0;
    if (!ticking_) return;
    ticker_.expires_at(std::max(ticker_.expiry() + kTick, now));
    tick();
  });
}

void StudioServer::Body::find_file(
    const std::string& path, const std::string& query,
    const std::function<void(std::optional<Served>, const std::string&)>& then) {
  commands_.add([this, path, query, then] {
    std::optional<Served> served;
    std::string fault;
    try {
      for (FileProvider* files : files_) {
        if (!served) served = files->find(path, query_items(query));
      }
    } catch (const std::exception& error) { fault = error.what(); }
    asio::post(io_, [then, served = std::move(served), fault] { then(served, fault); });
  });
}

StudioServer::StudioServer(const StudioConfig& config, RpcRegistry& rpc, std::vector<FileProvider*> files,
                           ServerHooks hooks)
    : body_(std::make_unique<Body>(config, rpc, std::move(files), std::move(hooks))) {}
StudioServer::~StudioServer() = default;

void StudioServer::begin(const StreamInfo& info) {
  body_->ring.begin(info);
  body_->hall.greet_anew();
}
void StudioServer::hop(const HopResult& hop) { body_->ring.hop(hop); }
void StudioServer::end() { body_->ring.end(); }
void StudioServer::announce(const std::string& topic, const json& message) {
  body_->hall.announce(topic, message);
}
int StudioServer::port() const { return body_->port(); }
std::string StudioServer::url() const { return body_->url(); }

}  // namespace odas
