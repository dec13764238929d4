// SPDX-License-Identifier: MIT
#include "odas/studio/live_session.hpp"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

namespace odas {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Error = boost::system::error_code;
using Clock = ClientFeed::Clock;
using Request = http::request<http::string_body>;

constexpr std::size_t kMostMessage = std::size_t{2} << 20;  // of a client: a configuration, at most

class LiveSession final : public StudioClient, public std::enable_shared_from_this<LiveSession> {
 public:
  LiveSession(WebStream stream, StudioServer::Body& server, Role r)
      : StudioClient(
            server.ring, [&server](std::uint64_t lost) { return server.hall.health(lost); }, r),
        socket_(std::move(stream)),
        server_(server) {}
  ~LiveSession() override { server_.connection_ended(); }

  void start(Request request) {
    request_ = std::move(request);
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(websocket::stream_base::timeout{kBrowserPatience / 2, std::chrono::seconds(30), true});
    socket_.read_message_max(kMostMessage);
    socket_.auto_fragment(false);
    socket_.async_accept(request_, [self = shared_from_this()](Error error) {
      if (error) return;
      self->open_ = true;
      self->server_.add(self);
      self->read();
    });
  }

  void wake(Clock::time_point now) override {
    if (!open_) return;
    if (sending_) {
      if (now - since_ > kBrowserPatience) {
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
    socket_.async_write(asio::buffer(*bytes_), [self = shared_from_this()](Error error, std::size_t) {
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
    socket_.async_read(buffer_, [self = shared_from_this()](Error error, std::size_t) {
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

  websocket::stream<WebStream, false> socket_;  // without compression
  StudioServer::Body& server_;
  Request request_;
  beast::flat_buffer buffer_;
  std::shared_ptr<const std::string> bytes_;
  Clock::time_point since_{};
  bool open_ = false, sending_ = false;
};

}  // namespace

void start_live_session(WebStream stream, StudioServer::Body& server, Role role, Request request) {
  std::make_shared<LiveSession>(std::move(stream), server, role)->start(std::move(request));
}

}  // namespace odas
