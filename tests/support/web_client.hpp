// SPDX-License-Identifier: MIT
// A browser's part in tests: HTTP requests as they are written, and the WebSocket of RFC 6455.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "support/net_peer.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::test {

/// One answer, taken apart.
struct HttpAnswer {
  int status = 0;  // 0: nobody answered
  std::string head, body;

  /// The value of a header; "": it is not there. `name` in lower case.
  [[nodiscard]] std::string header(std::string_view name) const {
    std::string lower = head;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c;
    const std::size_t at = lower.find("\r\n" + std::string(name) + ": ");
    if (at == std::string::npos) return "";
    const std::size_t begin = at + name.size() + 4;
    return head.substr(begin, head.find("\r\n", begin) - begin);
  }
};

/// Sends `request` as it is, and takes all until the server closes.
inline HttpAnswer http_exchange(int port, const std::string& request) {
  const NetPeer peer = NetPeer::dial(port);
  peer.send(request);
  const std::string all = peer.receive_all();
  HttpAnswer answer;
  const std::size_t end = all.find("\r\n\r\n");
  if (end == std::string::npos || all.size() < 12) return answer;
  answer.status = std::stoi(all.substr(9, 3));
  answer.head = all.substr(0, end + 2);
  answer.body = all.substr(end + 4);
  return answer;
}

/// GET, with more headers as `Name: value\r\n`.
inline HttpAnswer http_get(int port, const std::string& target, const std::string& headers = "") {
  const bool has_host = headers.find("Host:") != std::string::npos;
  return http_exchange(port, "GET " + target + " HTTP/1.1\r\n" +
                                 (has_host ? "" : "Host: 127.0.0.1:" + std::to_string(port) + "\r\n") +
                                 "Connection: close\r\n" + headers + "\r\n");
}

/// A WebSocket to /api/v1/live.
class WebClient {
 public:
  struct Message {
    int opcode = 0;  // 1 text, 2 binary, 8 close, 9 ping
    std::string payload;
  };

  explicit WebClient(int port, const std::string& target = "/api/v1/live", const std::string& headers = "")
      : peer_(NetPeer::dial(port)) {
    const bool has_host = headers.find("Host:") != std::string::npos;
    peer_.send("GET " + target + " HTTP/1.1\r\n" +
               (has_host ? "" : "Host: 127.0.0.1:" + std::to_string(port) + "\r\n") +
               "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
               headers + "\r\n");
    while (bytes_.find("\r\n\r\n") == std::string::npos) {
      const std::string piece = peer_.receive();
      if (piece.empty()) return;
      bytes_ += piece;
    }
    const std::size_t end = bytes_.find("\r\n\r\n") + 4;
    head_ = bytes_.substr(0, end);
    bytes_.erase(0, end);
    open_ = head_.starts_with("HTTP/1.1 101");
  }

  [[nodiscard]] bool open() const noexcept { return open_; }
  [[nodiscard]] const std::string& head() const noexcept { return head_; }
  [[nodiscard]] NetPeer& peer() noexcept { return peer_; }

  void send(const std::string& text) const { send_frame(0x81, text); }
  void send_frame(int first_byte, const std::string& payload) const {
    std::string frame(1, static_cast<char>(first_byte));
    if (payload.size() < 126) {
      frame += static_cast<char>(0x80U | payload.size());
    } else if (payload.size() < 65536) {
      frame += static_cast<char>(0x80U | 126U);
      frame += static_cast<char>(payload.size() >> 8);
      frame += static_cast<char>(payload.size() & 0xFF);
    } else {
      frame += static_cast<char>(0x80U | 127U);
      for (int shift = 56; shift >= 0; shift -= 8) frame += static_cast<char>(payload.size() >> shift & 0xFF);
    }
    frame += std::string(4, '\0');  // the mask: none
    peer_.send(frame + payload);
  }

  /// The next message; none: the server has gone, or is silent for too long. Pings are answered.
  std::optional<Message> next(int patience_ms = kPeerPatienceMs) {
    for (;;) {
      if (auto message = cut()) {
        if (message->opcode == 8) peer_.close();
        if (message->opcode == 9) {
          send_frame(0x8A, message->payload);
          continue;
        }
        return message;
      }
      const std::string piece = peer_.receive(65536, patience_ms);
      if (piece.empty()) return std::nullopt;
      bytes_ += piece;
    }
  }

 private:
  std::optional<Message> cut() {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes_[i]); };
    if (bytes_.size() < 2) return std::nullopt;
    std::size_t size = byte(1) & 0x7FU, head = 2;
    const std::size_t extra = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (bytes_.size() < head + extra) return std::nullopt;
    if (extra > 0) size = 0;
    for (std::size_t i = 0; i < extra; ++i) size = size << 8 | byte(head + i);
    head += extra;
    if (bytes_.size() < head + size) return std::nullopt;
    Message message{byte(0) & 0x0F, bytes_.substr(head, size)};
    bytes_.erase(0, head + size);
    return message;
  }

  NetPeer peer_;
  std::string head_, bytes_;
  bool open_ = false;
};

/// The next message of this type, others are passed over.
inline nlohmann::json next(WebClient& client, const std::string& type) {
  while (const auto message = client.next()) {
    if (message->opcode != 1) continue;
    nlohmann::json parsed = nlohmann::json::parse(message->payload);
    if (parsed.at("type") == type) return parsed;
  }
  ADD_FAILURE() << "no message '" << type << "' came";
  return {};
}

}  // namespace odas::test
