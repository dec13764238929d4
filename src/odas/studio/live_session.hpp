// SPDX-License-Identifier: MIT
// Part of http_server.cpp, the only file that is compiled with Boost.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>

#include "odas/studio/server_body.hpp"

namespace odas {

namespace http = beast::http;
namespace websocket = beast::websocket;

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

  void start(http::request<http::string_body> request) {
    request_ = std::move(request);
    beast::get_lowest_layer(socket_).expires_never();
    websocket::stream_base::timeout patience{kPatience / 2, std::chrono::seconds(30), true};
    socket_.set_option(patience);
    socket_.read_message_max(kMost);
    socket_.auto_fragment(false);
    socket_.async_accept(request_, [self = this->shared_from_this()](NetError error) {
      if (error) return;
      self->open_ = true;
      self->server_.add(self);
      self->read();
    });
  }

  void wake(ClientFeed::Clock::time_point now) override {
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
    socket_.async_write(asio::buffer(*bytes_),
                        [self = this->shared_from_this()](NetError error, std::size_t) {
                          self->sending_ = false;
                          if (error) {
                            self->drop();
                          } else {
                            self->wake(ClientFeed::Clock::now());
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
    socket_.async_read(buffer_, [self = this->shared_from_this()](NetError error, std::size_t) {
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

  static constexpr std::size_t kMost = std::size_t{2} << 20;  // of a message: a configuration

  websocket::stream<Stream> socket_;
  StudioServer::Body& server_;
  http::request<http::string_body> request_;
  beast::flat_buffer buffer_;
  std::shared_ptr<const std::string> bytes_;
  ClientFeed::Clock::time_point since_{};
  bool open_ = false, sending_ = false;
};

}  // namespace odas
