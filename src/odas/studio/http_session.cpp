// SPDX-License-Identifier: MIT
#include "odas/studio/http_session.hpp"

#include <fstream>

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "odas/studio/assets.hpp"
#include "odas/studio/byte_range.hpp"
#include "odas/studio/live_session.hpp"
#include "odas/studio/metrics_text.hpp"

namespace odas {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using Error = boost::system::error_code;
using Request = http::request<http::string_body>;

constexpr std::uint32_t kMostHeader = 16U << 10;
constexpr std::size_t kMostBody = 64U << 10;
constexpr std::size_t kFilePiece = std::size_t{64} << 10;

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }
beast::string_view view(std::string_view text) { return {text.data(), text.size()}; }

/// One connection until it asks for a WebSocket or goes.
class HttpSession final : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(WebStream stream, StudioServer::Body& server) : stream_(std::move(stream)), server_(&server) {}
  ~HttpSession() {
    if (server_ != nullptr) server_->connection_ended();
  }
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void start() {
    if (!stream_.is_secure()) return read({});
    expire();
    stream_.handshake(then(&HttpSession::read));
  }

 private:
  /// What comes next, in one type for all: each would be a tree of Beast's templates of its own.
  struct Then {
    std::shared_ptr<HttpSession> self;
    void (HttpSession::*step)(Error);
    void operator()(Error error, std::size_t = 0) const { ((*self).*step)(error); }
  };
  [[nodiscard]] Then then(void (HttpSession::*step)(Error)) { return {shared_from_this(), step}; }
  void expire() { stream_.next_layer().expires_after(kBrowserPatience); }

  void read(Error error) {
    if (error) return;
    parser_.emplace();
    parser_->header_limit(kMostHeader);
    parser_->body_limit(kMostBody);
    expire();
    http::async_read(stream_, buffer_, *parser_, then(&HttpSession::take));
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
    if (beast::websocket::is_upgrade(request_)) return go_live();
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
    StudioServer::Body& server = *std::exchange(server_, nullptr);  // the connection is the session's now
    start_live_session(std::move(stream_), server, role_, std::move(request_));
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
    stream_.next_layer().expires_never();
    server_->find_file(path_, std::string(query_),
                       [self = shared_from_this()](std::optional<Served> served, std::string fault) {
                         if (!fault.empty()) return self->refuse(http::status::internal_server_error, fault);
                         if (!served) return self->refuse(http::status::not_found, "there is no such file");
                         self->send_served(std::move(*served));
                       });
  }

  /// The token goes from the address into a cookie, so that it is in no bookmark and no history.
  void keep_token() {
    begin(http::status::see_other);
    response_->set(http::field::location, "/");
    response_->set(http::field::set_cookie,
                   fmt::format("odas_token={}; Path=/; HttpOnly; SameSite=Strict; Max-Age=2592000{}",
                               query_value(query_, "token").value_or(""), server_->tls() ? "; Secure" : ""));
    send({});
  }

  void send_asset(const Asset& asset) {
    const bool same = view(request_[http::field::if_none_match]) == asset.etag;
    const bool packed = view(request_[http::field::accept_encoding]).find("gzip") != std::string_view::npos;
    begin(same ? http::status::not_modified : http::status::ok, asset.type);
    response_->set(http::field::etag, view(asset.etag));
    response_->set(http::field::cache_control, "no-cache");
    response_->set(http::field::vary, "Accept-Encoding");
    if (packed) response_->set(http::field::content_encoding, "gzip");
    send(same ? std::string_view() : packed ? asset.gzip : asset.bytes);
  }

  void send_text(std::string text, const char* type) {
    begin(http::status::ok, type);
    response_->set(http::field::cache_control, "no-store");
    text_ = std::move(text);
    send(text_);
  }

  void refuse(http::status status, const std::string& why, bool keep = true) {
    begin(status, "text/plain; charset=utf-8");
    if (status == http::status::unauthorized) response_->set(http::field::www_authenticate, "Bearer");
    response_->keep_alive(keep && request_.keep_alive());
    text_ = why + "\n";
    send(text_);
  }

  void send_served(Served served) {
    download_ = served.download_name;
    if (served.file.empty()) return send_text(std::move(served.body), served.type.c_str());
    file_ = std::make_unique<std::ifstream>(served.file, std::ios::binary);
    std::error_code failed;
    const std::uint64_t size = std::filesystem::file_size(served.file, failed);
    if (served.remove_file) std::filesystem::remove(served.file, failed);
    if (!*file_) return refuse(http::status::not_found, "the file cannot be read");
    ByteRange range{0, size == 0 ? 0 : size - 1};
    const RangeKind kind = read_range(view(request_[http::field::range]), size, range);
    if (kind == RangeKind::unsatisfiable) {
      return refuse(http::status::range_not_satisfiable, fmt::format("the file has {} bytes", size));
    }
    const bool part = kind == RangeKind::part;
    begin(part ? http::status::partial_content : http::status::ok, served.type);
    response_->set(http::field::accept_ranges, "bytes");
    response_->set(http::field::cache_control, "no-cache");
    if (part) {
      response_->set(http::field::content_range,
                     fmt::format("bytes {}-{}/{}", range.first, range.last, size));
    }
    left_ = size == 0 ? 0 : range.size();
    file_->seekg(static_cast<std::streamoff>(range.first));
    response_->content_length(left_);
    send_header(&HttpSession::send_piece);
  }

  void send_piece(Error error) {
    if (error == http::error::need_buffer) error = {};
    if (error) return;
    if (left_ == 0 || request_.method() == http::verb::head) return sent({});
    piece_.resize(std::min<std::uint64_t>(left_, kFilePiece));
    file_->read(piece_.data(), static_cast<std::streamsize>(piece_.size()));
    if (file_->gcount() != static_cast<std::streamsize>(piece_.size())) return shut();  // it became shorter
    left_ -= piece_.size();
    response_->body() = {piece_.data(), piece_.size(), left_ > 0};
    expire();
    http::async_write(stream_, *serializer_, then(&HttpSession::send_piece));
  }

  /// A response with what all have.
  void begin(http::status status, std::string_view type = {}) {
    serializer_.reset();
    response_.emplace(status, 11);
    response_->keep_alive(request_.keep_alive());
    response_->set(http::field::server, "odas");
    response_->set("Content-Security-Policy", server_->content_policy());
    response_->set("X-Content-Type-Options", "nosniff");
    response_->set("X-Frame-Options", "DENY");
    response_->set("Referrer-Policy", "no-referrer");
    response_->set("Cross-Origin-Resource-Policy", "same-origin");
    response_->set("Permissions-Policy", "camera=(), microphone=(), geolocation=(), autoplay=(self)");
    if (!type.empty()) response_->set(http::field::content_type, view(type));
    if (!download_.empty()) {
      response_->set(http::field::content_disposition, fmt::format("attachment; filename=\"{}\"", download_));
    }
  }

  /// The response, whose body is `body`: it outlives the sending. To HEAD goes its length, and nothing of it.
  void send(std::string_view body) {
    response_->content_length(body.size());
    if (body.empty() || request_.method() == http::verb::head) return send_header(&HttpSession::sent);
    serializer_.emplace(*response_);
    response_->body() = {const_cast<char*>(body.data()), body.size(), false};  // it is only read
    expire();
    http::async_write(stream_, *serializer_, then(&HttpSession::sent));
  }

  void send_header(void (HttpSession::*next)(Error)) {
    serializer_.emplace(*response_);
    response_->body() = {nullptr, 0, left_ > 0};
    expire();
    http::async_write_header(stream_, *serializer_, then(next));
  }

  void sent(Error error) {
    if (error) return;
    file_.reset();
    left_ = 0;
    download_.clear();
    if (response_->keep_alive()) {
      read({});
    } else {
      shut();
    }
  }

  void shut() {
    Error ignored;
    stream_.next_layer().socket().shutdown(asio::socket_base::shutdown_send, ignored);
  }

  WebStream stream_;
  StudioServer::Body* server_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Request request_;
  std::string path_;
  std::string_view query_;  // in request_
  Role role_ = Role::viewer;
  std::optional<http::response<http::buffer_body>> response_;
  std::optional<http::response_serializer<http::buffer_body>> serializer_;
  std::string text_;      // its body
  std::string download_;  // its name, if it is to be kept
  // A file on its way.
  std::unique_ptr<std::ifstream> file_;
  std::vector<char> piece_;
  std::uint64_t left_ = 0;
};

}  // namespace

void start_http_session(WebStream stream, StudioServer::Body& server) {
  std::make_shared<HttpSession>(std::move(stream), server)->start();
}

}  // namespace odas
