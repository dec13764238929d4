// SPDX-License-Identifier: MIT
// Part of http_server.cpp, the only file that is compiled with Boost.
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "odas/studio/assets.hpp"
#include "odas/studio/byte_range.hpp"
#include "odas/studio/live_session.hpp"
#include "odas/studio/metrics_text.hpp"

namespace odas {

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
      stream_.async_handshake(asio::ssl::stream_base::server,
                              [self = this->shared_from_this()](NetError error) {
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
                     [self = this->shared_from_this()](NetError error, std::size_t) { self->take(error); });
  }

  void take(NetError error) {
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
        [self = this->shared_from_this()](NetError error, std::size_t) { self->send_piece(error); });
  }

  void send_piece(NetError error) {
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
    http::async_write(stream_, *serializer_, [self = this->shared_from_this()](NetError failed, std::size_t) {
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
    const auto done = [self = this->shared_from_this(), keep, response](NetError error, std::size_t) {
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
                               [done, serializer](NetError error, std::size_t n) { done(error, n); });
    } else {
      http::async_write(stream_, *response, done);
    }
  }

  void shut() {
    NetError ignored;
    beast::get_lowest_layer(stream_).socket().shutdown(Tcp::socket::shutdown_send, ignored);
  }

  static constexpr std::uint32_t kMostHeader = 16U << 10;
  static constexpr std::size_t kMostBody = 64U << 10;
  static constexpr std::size_t kFilePiece = std::size_t{64} << 10;

  Stream stream_;
  StudioServer::Body* server_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  http::request<http::string_body> request_;
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

}  // namespace odas
