// SPDX-License-Identifier: MIT
#include "odas/studio/web_stream.hpp"

#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>

namespace odas {

WebStream::WebStream(Plain plain) : stream_(std::move(plain)) {}
WebStream::WebStream(Plain plain, boost::asio::ssl::context& tls)
    : stream_(std::in_place_type<Secure>, std::move(plain), tls) {}
WebStream::WebStream(WebStream&& other) noexcept = default;
WebStream::~WebStream() = default;

WebStream::Plain& WebStream::next_layer() noexcept {
  Secure* const tls = std::get_if<Secure>(&stream_);
  return tls != nullptr ? tls->next_layer() : std::get<Plain>(stream_);
}

void WebStream::handshake(std::function<void(Error)> then) {
  std::get<Secure>(stream_).async_handshake(boost::asio::ssl::stream_base::server, std::move(then));
}

void WebStream::read_some(const Few<boost::asio::mutable_buffer>& buffers,
                          std::function<void(Error, std::size_t)> then) {
  std::visit([&](auto& stream) { stream.async_read_some(buffers, std::move(then)); }, stream_);
}

void WebStream::write_some(const Few<boost::asio::const_buffer>& buffers,
                           std::function<void(Error, std::size_t)> then) {
  std::visit([&](auto& stream) { stream.async_write_some(buffers, std::move(then)); }, stream_);
}

void WebStream::tear_down(boost::beast::role_type role, std::function<void(Error)> then) {
  using boost::beast::websocket::async_teardown;
  std::visit([&](auto& stream) { async_teardown(role, stream, std::move(then)); }, stream_);
}

}  // namespace odas
