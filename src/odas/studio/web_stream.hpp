// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>  // before Boost 1.74, which forgets it
#include <variant>

#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>

namespace odas {

/// The connection of a browser, plain or TLS, as one type: what Boost.Asio calls an AsyncStream. Beast's
/// templates, which are slow to compile, are made once for both, and end here: what comes next is a
/// function.
class WebStream {
 public:
  using Plain = boost::beast::tcp_stream;
  using Secure = boost::beast::ssl_stream<Plain>;
  using executor_type = Plain::executor_type;
  using next_layer_type = Plain;
  using Error = boost::system::error_code;

  explicit WebStream(Plain plain);
  WebStream(Plain plain, boost::asio::ssl::context& tls);
  WebStream(WebStream&& other) noexcept;
  ~WebStream();

  [[nodiscard]] bool is_secure() const noexcept { return std::holds_alternative<Secure>(stream_); }
  [[nodiscard]] Plain& next_layer() noexcept;
  [[nodiscard]] executor_type get_executor() noexcept { return next_layer().get_executor(); }

  /// Of TLS alone.
  void handshake(std::function<void(Error)> then);

  template <class Buffers, class Handler>
  void async_read_some(const Buffers& buffers, Handler&& handler) {
    read_some(few<boost::asio::mutable_buffer>(buffers),
              function<std::size_t>(std::forward<Handler>(handler)));
  }
  template <class Buffers, class Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler) {
    write_some(few<boost::asio::const_buffer>(buffers),
               function<std::size_t>(std::forward<Handler>(handler)));
  }
  /// How a WebSocket ends: found by Beast.
  template <class Handler>
  friend void async_teardown(boost::beast::role_type role, WebStream& stream, Handler&& handler) {
    stream.tear_down(role, function<>(std::forward<Handler>(handler)));
  }

 private:
  /// The first buffers of a sequence: who reads or writes some may do with fewer.
  template <class Buffer>
  struct Few {
    std::array<Buffer, 16> buffers;
    std::size_t count = 0;
    using value_type = Buffer;
    using const_iterator = const Buffer*;
    [[nodiscard]] const_iterator begin() const noexcept { return buffers.data(); }
    [[nodiscard]] const_iterator end() const noexcept { return buffers.data() + count; }
  };
  template <class Buffer, class Buffers>
  static Few<Buffer> few(const Buffers& all) {
    Few<Buffer> some;
    const auto end = boost::asio::buffer_sequence_end(all);
    for (auto at = boost::asio::buffer_sequence_begin(all); at != end && some.count < some.buffers.size();
         ++at) {
      if (Buffer(*at).size() > 0) some.buffers[some.count++] = *at;
    }
    return some;
  }
  /// A handler may be one that moves alone.
  template <class... More, class Handler>
  static std::function<void(Error, More...)> function(Handler&& handler) {
    return [kept = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
               Error error, More... more) { (*kept)(error, more...); };
  }

  void read_some(const Few<boost::asio::mutable_buffer>& buffers,
                 std::function<void(Error, std::size_t)> then);
  void write_some(const Few<boost::asio::const_buffer>& buffers,
                  std::function<void(Error, std::size_t)> then);
  void tear_down(boost::beast::role_type role, std::function<void(Error)> then);

  std::variant<Plain, Secure> stream_;
};

}  // namespace odas
