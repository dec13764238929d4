// SPDX-License-Identifier: MIT
// The only file that sees Boost. What is to be sent is decided elsewhere: by Gate, assets, FileProvider,
// ClientFeed.
#include <array>
#include <condition_variable>
#include <deque>
#include <fstream>
#include <list>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>  // before Boost 1.74, which forgets it

#include <boost/asio/ip/host_name.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/base/host.hpp"
#include "odas/engine/signals_blocked.hpp"
#include "odas/studio/assets.hpp"
#include "odas/studio/byte_range.hpp"
#include "odas/studio/client_hall.hpp"
#include "odas/studio/gate.hpp"
#include "odas/studio/metrics_text.hpp"
#include "odas/studio/rare_notes.hpp"
#include "odas/studio/server.hpp"
#include "odas/studio/work_queue.hpp"

namespace odas {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Error = boost::system::error_code;
using Clock = ClientFeed::Clock;
using nlohmann::json;
using Request = http::request<http::string_body>;

constexpr auto kPatience = std::chrono::seconds(10);  // with a request, and with who takes nothing
constexpr auto kTick = std::chrono::microseconds(16667);
constexpr std::uint32_t kMostHeader = 16U << 10;
constexpr std::size_t kMostBody = 64U << 10;
constexpr std::size_t kMostMessage = std::size_t{2} << 20;  // of a client: a configuration, at most
constexpr std::size_t kFilePiece = std::size_t{64} << 10;

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

}  // namespace

class StudioServer::Body {
 public:
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
  asio::io_context io_{1};

 public:
  Gate gate;
  HopRing ring;

 private:
  void listen();
  void accept();
  void admit(Tcp::socket socket);
  void start_ticking();
  void tick();

  std::optional<asio::ssl::context> tls_;
  Tcp::acceptor acceptor_{io_};
  asio::steady_timer retry_{io_}, ticker_{io_};
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

namespace {

/// One WebSocket connection.
template <class Stream>
class LiveSession final : public StudioClient, public std::enable_shared_from_this<LiveSession<Stream>> {
 public:
  LiveSession(Stream stream, StudioServer::Body& server, Role r)
      : StudioClient(
            server.ring, [&server](std::uint64_t lost) { return server.hall.health(lost); }, r),
        socket_(std::move(stream)),
        server_(server) {}
  ~LiveSession() override { server_.connection_ended(); }

  void start(Request request) {
    request_ = std::move(request);
    beast::get_lowest_layer(socket_).expires_never();
    websocket::stream_base::timeout patience{kPatience / 2, std::chrono::seconds(30), true};
    socket_.set_option(patience);
    socket_.read_message_max(kMostMessage);
    socket_.auto_fragment(false);
    socket_.async_accept(request_, [self = this->shared_from_this()](Error error) {
      if (error) return;
      self->open_ = true;
      self->server_.add(self);
      self->read();
    });
  }

  void wake(Clock::time_point now) override {
    if (!open_) return;
    if (sending_) {
      if (now - since_ > kPatience) {
        server_.note("stalled", "a browser took nothing for ten seconds, and was let go");
        drop();
      }
      return;
    }
    auto message = feed.next(now);
    if (!message) return;
    sending_ = true;
    since_ = now;
    bytes_ = std::move(message->bytes);
    socket_.binary(message->binary);
    socket_.async_write(asio::buffer(*bytes_), [self = this->shared_from_this()](Error error, std::size_t) {
      self->sending_ = false;
      if (error) {
        self->drop();
      } else {
        self->wake(Clock::now());
      }
    });
  }

  void drop() {
    if (!std::exchange(open_, false)) return;
    beast::get_lowest_layer(socket_).close();
    server_.hall.remove(*this);
  }

 private:
  void read() {
    socket_.async_read(buffer_, [self = this->shared_from_this()](Error error, std::size_t) {
      if (error || !self->open_) {
        if (error == websocket::error::message_too_big) {
          self->server_.note("too big", "a browser sent a message of more than 2 MiB, and was let go");
        }
        self->drop();
        return;
      }
      const auto data = self->buffer_.cdata();
      if (self->socket_.got_text()) {
        self->server_.hall.hear(self, {static_cast<const char*>(data.data()), data.size()});
      }
      self->buffer_.consume(self->buffer_.size());
      self->read();
    });
  }

  websocket::stream<Stream> socket_;
  StudioServer::Body& server_;
  Request request_;
  beast::flat_buffer buffer_;
  std::shared_ptr<const std::string> bytes_;
  Clock::time_point since_{};
  bool open_ = false, sending_ = false;
};

/// One connection until it asks for a WebSocket or goes.
template <class Stream>
class HttpSession final : public std::enable_shared_from_this<HttpSession<Stream>> {
 public:
  HttpSession(Stream stream, StudioServer::Body& server) : stream_(std::move(stream)), server_(&server) {}
  ~HttpSession() {
    if (server_ != nullptr) server_->connection_ended();
  }
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void start() {
    if constexpr (!std::is_same_v<Stream, beast::tcp_stream>) {
      beast::get_lowest_layer(stream_).expires_after(kPatience);
      stream_.async_handshake(asio::ssl::stream_base::server, [self = this->shared_from_this()](Error error) {
        if (!error) self->read();
      });
    } else {
      read();
    }
  }

 private:
  void read() {
    parser_.emplace();
    parser_->header_limit(kMostHeader);
    parser_->body_limit(kMostBody);
    beast::get_lowest_layer(stream_).expires_after(kPatience);
    http::async_read(stream_, buffer_, *parser_,
                     [self = this->shared_from_this()](Error error, std::size_t) { self->take(error); });
  }

  void take(Error error) {
    if (error == http::error::header_limit || error == http::error::body_limit) {
      server_->note("too long", "a request was too long, and was refused");
      return refuse(http::status::request_header_fields_too_large, "the request is too long", false);
    }
    if (error) {
      const bool gone = error == http::error::end_of_stream || error == beast::error::timeout ||
                        error.category() == asio::error::get_system_category();
      if (!gone && error.category() == http::make_error_code(http::error::bad_method).category()) {
        return refuse(http::status::bad_request, "that is no HTTP request", false);
      }
      return;
    }
    request_ = parser_->release();
    const std::string_view target = view(request_.target());
    const std::size_t mark = std::min(target.find('?'), target.size());
    path_ = percent_decoded(target.substr(0, mark)).value_or("");
    query_ = target.substr(std::min(mark + 1, target.size()));
    const Gate::Verdict verdict = server_->gate.judge(
        {view(request_[http::field::host]), view(request_[http::field::origin]),
         view(request_[http::field::authorization]), view(request_[http::field::cookie]), query_});
    if (!verdict.role) {
      server_->note(verdict.why, "a request was refused: " + verdict.why);
      return refuse(static_cast<http::status>(verdict.status), verdict.why);
    }
    role_ = *verdict.role;
    if (websocket::is_upgrade(request_)) return go_live();
    if (request_.method() != http::verb::get && request_.method() != http::verb::head) {
      return refuse(http::status::method_not_allowed, "only GET and HEAD are known here");
    }
    if (verdict.by_query && path_ == "/") return keep_token();
    route();
  }

  void go_live() {
    if (path_ != "/api/v1/live") return refuse(http::status::not_found, "the WebSocket is at /api/v1/live");
    if (server_->hall.size() >= StudioServer::kMostClients) {
      server_->note("clients", "more browsers came than can be served");
      return refuse(http::status::service_unavailable, "too many browsers are here already");
    }
    auto session = std::make_shared<LiveSession<Stream>>(std::move(stream_), *server_, role_);
    server_ = nullptr;  // the connection is the session's now
    session->start(std::move(request_));
  }

  void route() {
    if (const Asset* asset = find_asset(path_)) return send_asset(*asset);
    if (path_ == "/api/v1/info") return send_text(server_->hall.hello(role_).dump(), "application/json");
    if (path_ == "/metrics") {
      return send_text(metrics_text(server_->hall.figures()), "text/plain; version=0.0.4");
    }
    if (path_ == "/healthz") {
      const std::string failure = server_->hooks().failure ? server_->hooks().failure() : "";
      if (!failure.empty()) return refuse(http::status::service_unavailable, failure);
      return send_text("ok\n", "text/plain; charset=utf-8");
    }
    if (!path_.starts_with("/api/v1/")) return refuse(http::status::not_found, "there is no such page");
    beast::get_lowest_layer(stream_).expires_never();
    server_->find_file(path_, std::string(query_),
                       [self = this->shared_from_this()](std::optional<Served> served, std::string fault) {
                         if (!fault.empty()) return self->refuse(http::status::internal_server_error, fault);
                         if (!served) return self->refuse(http::status::not_found, "there is no such file");
                         self->send_served(std::move(*served));
                       });
  }

  /// The token goes from the address into a cookie, so that it is in no bookmark and no history.
  void keep_token() {
    auto response = make<http::empty_body>(http::status::see_other);
    response->set(http::field::location, "/");
    response->set(http::field::set_cookie,
                  fmt::format("odas_token={}; Path=/; HttpOnly; SameSite=Strict; Max-Age=2592000{}",
                              query_value(query_, "token").value_or(""), server_->tls() ? "; Secure" : ""));
    response->content_length(0);
    send(std::move(response));
  }

  void send_asset(const Asset& asset) {
    const bool same = view(request_[http::field::if_none_match]) == asset.etag;
    const bool packed = view(request_[http::field::accept_encoding]).find("gzip") != std::string_view::npos;
    const std::string_view bytes = packed ? asset.gzip : asset.bytes;
    auto response = make<http::span_body<const char>>(same ? http::status::not_modified : http::status::ok);
    response->set(http::field::content_type, beast::string_view(asset.type.data(), asset.type.size()));
    response->set(http::field::etag, beast::string_view(asset.etag.data(), asset.etag.size()));
    response->set(http::field::cache_control, "no-cache");
    response->set(http::field::vary, "Accept-Encoding");
    if (packed) response->set(http::field::content_encoding, "gzip");
    response->content_length(same ? 0 : bytes.size());
    if (!same && request_.method() == http::verb::get) {
      response->body() = beast::span<const char>(bytes.data(), bytes.size());
    }
    send(std::move(response));
  }

  void send_text(std::string text, const char* type) {
    auto response = make<http::string_body>(http::status::ok);
    response->set(http::field::content_type, type);
    response->set(http::field::cache_control, "no-store");
    response->content_length(text.size());
    if (request_.method() == http::verb::get) response->body() = std::move(text);
    send(std::move(response));
  }

  void refuse(http::status status, const std::string& why, bool keep = true) {
    auto response = make<http::string_body>(status);
    response->set(http::field::content_type, "text/plain; charset=utf-8");
    if (status == http::status::unauthorized) response->set(http::field::www_authenticate, "Bearer");
    response->body() = why + "\n";
    response->prepare_payload();
    response->keep_alive(keep && request_.keep_alive());
    send(std::move(response));
  }

  void send_served(Served served) {
    if (served.file.empty()) {
      if (!served.download_name.empty()) download_ = served.download_name;
      return send_text(std::move(served.body), served.type.c_str());
    }
    download_ = served.download_name;
    file_ = std::make_unique<std::ifstream>(served.file, std::ios::binary);
    std::error_code failed;
    const std::uint64_t size = std::filesystem::file_size(served.file, failed);
    if (served.remove_file) std::filesystem::remove(served.file, failed);
    if (!*file_) return refuse(http::status::not_found, "the file cannot be read");
    ByteRange range{0, size == 0 ? 0 : size - 1};
    const RangeKind kind = read_range(view(request_[http::field::range]), size, range);
    const bool part = kind == RangeKind::part;
    if (kind == RangeKind::unsatisfiable) {
      return refuse(http::status::range_not_satisfiable, fmt::format("the file has {} bytes", size));
    }
    response_ = make<http::buffer_body>(part ? http::status::partial_content : http::status::ok);
    response_->set(http::field::content_type, served.type);
    response_->set(http::field::accept_ranges, "bytes");
    response_->set(http::field::cache_control, "no-cache");
    if (part) {
      response_->set(http::field::content_range,
                     fmt::format("bytes {}-{}/{}", range.first, range.last, size));
    }
    left_ = size == 0 ? 0 : range.size();
    response_->content_length(left_);
    if (request_.method() == http::verb::head) left_ = 0;
    file_->seekg(static_cast<std::streamoff>(range.first));
    response_->body().data = nullptr;
    response_->body().more = left_ > 0;
    serializer_.emplace(*response_);
    beast::get_lowest_layer(stream_).expires_after(kPatience);
    http::async_write_header(
        stream_, *serializer_,
        [self = this->shared_from_this()](Error error, std::size_t) { self->send_piece(error); });
  }

  void send_piece(Error error) {
    if (error == http::error::need_buffer) error = {};
    if (error) return;
    if (left_ == 0 || request_.method() == http::verb::head) {
      file_.reset();
      if (!response_->keep_alive()) return shut();
      return read();
    }
    piece_.resize(std::min<std::uint64_t>(left_, kFilePiece));
    file_->read(piece_.data(), static_cast<std::streamsize>(piece_.size()));
    if (file_->gcount() != static_cast<std::streamsize>(piece_.size())) return shut();  // it became shorter
    left_ -= piece_.size();
    response_->body().data = piece_.data();
    response_->body().size = piece_.size();
    response_->body().more = left_ > 0;
    beast::get_lowest_layer(stream_).expires_after(kPatience);
    http::async_write(stream_, *serializer_, [self = this->shared_from_this()](Error failed, std::size_t) {
      self->send_piece(failed);
    });
  }

  template <class Body>
  std::shared_ptr<http::response<Body>> make(http::status status) {
    auto response = std::make_shared<http::response<Body>>(status, 11);
    response->keep_alive(request_.keep_alive());
    response->set(http::field::server, "odas");
    response->set("Content-Security-Policy", server_->content_policy());
    response->set("X-Content-Type-Options", "nosniff");
    response->set("X-Frame-Options", "DENY");
    response->set("Referrer-Policy", "no-referrer");
    response->set("Cross-Origin-Resource-Policy", "same-origin");
    response->set("Permissions-Policy", "camera=(), microphone=(), geolocation=(), autoplay=(self)");
    if (!download_.empty()) {
      response->set(http::field::content_disposition, fmt::format("attachment; filename=\"{}\"", download_));
    }
    return response;
  }

  template <class Body>
  void send(std::shared_ptr<http::response<Body>> response) {
    beast::get_lowest_layer(stream_).expires_after(kPatience);
    const bool keep = response->keep_alive();
    const auto done = [self = this->shared_from_this(), keep, response](Error error, std::size_t) {
      if (error) return;
      self->download_.clear();
      if (keep) {
        self->read();
      } else {
        self->shut();
      }
    };
    if (request_.method() == http::verb::head) {  // the length of what there would be, and nothing of it
      auto serializer = std::make_shared<http::response_serializer<Body>>(*response);
      http::async_write_header(stream_, *serializer,
                               [done, serializer](Error error, std::size_t n) { done(error, n); });
    } else {
      http::async_write(stream_, *response, done);
    }
  }

  void shut() {
    Error ignored;
    beast::get_lowest_layer(stream_).socket().shutdown(Tcp::socket::shutdown_send, ignored);
  }

  Stream stream_;
  StudioServer::Body* server_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Request request_;
  std::string path_;
  std::string_view query_;  // in request_
  std::string download_;
  Role role_ = Role::viewer;
  // A file on its way.
  std::unique_ptr<std::ifstream> file_;
  std::shared_ptr<http::response<http::buffer_body>> response_;
  std::optional<http::response_serializer<http::buffer_body>> serializer_;
  std::vector<char> piece_;
  std::uint64_t left_ = 0;
};

}  // namespace

namespace {

std::string token_of(const StudioConfig& config) {
  if (!config.token.empty() || is_loopback_host(config.ip)) return config.token;
  return random_token();
}

std::vector<std::string> names_of(const StudioConfig& config) {
  std::vector<std::string> names = config.hosts;
  if (!config.ip.empty()) names.push_back(config.ip);
  Error error;
  const std::string own = asio::ip::host_name(error);
  if (!error && !own.empty()) names.insert(names.end(), {own, own + ".local"});
  return names;
}

/// `http://camera:8080`, of any address there.
std::string origin_of(const std::string& url) {
  const std::size_t slashes = url.find("://");
  if (slashes == std::string::npos) return "";
  const std::string origin = url.substr(0, url.find('/', slashes + 3));
  const bool clean = origin.find_first_of(" ;,'\"\r\n") == std::string::npos;
  return clean ? origin : "";
}

std::string policy_of(const StudioConfig& config) {
  return "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: "
         "blob: " +
         origin_of(config.camera.url) +
         "; connect-src 'self'; media-src 'self' blob:; font-src 'self'; worker-src 'self'; manifest-src "
         "'self'; "
         "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

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
      content_policy_(policy_of(config)),
      gate({(config_.token = token_of(config)), config.viewer_token}, names_of(config),
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
  const std::string scheme = tls() ? "https" : "http";
  std::string host = config_.ip.empty() ? "127.0.0.1" : config_.ip;
  if (host == "0.0.0.0" || host == "::") {
    Error error;
    const std::string own = asio::ip::host_name(error);
    host = error || own.empty() ? "127.0.0.1" : own;
  }
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  const std::string token = config_.token.empty() ? "" : "?token=" + config_.token;
  return fmt::format("{}://{}:{}/{}", scheme, host, port_, token);
}

void StudioServer::Body::listen() {
  const std::string host = config_.ip.empty() ? "127.0.0.1" : config_.ip;
  Error error;
  Tcp::resolver resolver(io_);
  const auto found = resolver.resolve(host, std::to_string(config_.port), Tcp::resolver::passive, error);
  if (error || found.empty()) throw ConfigError("studio.ip", "there is no address '" + host + "'");
  const Tcp::endpoint endpoint = found.begin()->endpoint();
  const auto fail = [&](const std::string& hint) {
    throw IoError(fmt::format("cannot listen on {}:{}: {}{}", host, config_.port, error.message(), hint));
  };
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error == asio::error::address_in_use) fail("; another program is there: choose another port");
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
  beast::tcp_stream stream(std::move(socket));
  if (tls_) {
    using Secure = beast::ssl_stream<beast::tcp_stream>;
    std::make_shared<HttpSession<Secure>>(Secure(std::move(stream), *tls_), *this)->start();
  } else {
    std::make_shared<HttpSession<beast::tcp_stream>>(std::move(stream), *this)->start();
  }
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
