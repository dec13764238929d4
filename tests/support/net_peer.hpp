// SPDX-License-Identifier: MIT
// Peers on loopback for tests: who dials, and who listens, as a program of a user would.
#pragma once

#include <array>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace odas::test {

inline constexpr int kPeerPatienceMs = 20000;  // longer than any test waits where all is well

/// Steps until `done`, or for as long as a peer is waited for.
template <class Done>
bool eventually(Done&& done) {
  for (int ms = 0; ms < kPeerPatienceMs; ms += 5) {
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

/// A connection. Everything waits at most kPeerPatienceMs.
class NetPeer {
 public:
  NetPeer() = default;
  explicit NetPeer(int socket) : socket_(socket) {}
  NetPeer(NetPeer&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}
  NetPeer& operator=(NetPeer&& other) noexcept {
    std::swap(socket_, other.socket_);
    return *this;
  }
  ~NetPeer() { close(); }

  /// Dials 127.0.0.1, once.
  static NetPeer dial(int port) {
    NetPeer peer(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(peer.socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) peer.close();
    return peer;
  }

  [[nodiscard]] bool open() const noexcept { return socket_ >= 0; }
  [[nodiscard]] int descriptor() const noexcept { return socket_; }

  /// False: the other side has gone.
  bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }
  /// What has come so far.
  [[nodiscard]] std::string receive_now() const {
    std::string all;
    for (std::string piece; !(piece = receive(65536, 0)).empty();) all += piece;
    return all;
  }
  /// What has come, once something has; "": the other side has gone, or is silent for too long.
  [[nodiscard]] std::string receive(std::size_t most = 65536, int patience_ms = kPeerPatienceMs) const {
    pollfd asked{socket_, POLLIN, 0};
    std::string bytes(most, '\0');
    if (::poll(&asked, 1, patience_ms) <= 0) return "";
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }
  /// All until the other side goes.
  [[nodiscard]] std::string receive_all() const {
    std::string all;
    for (std::string piece; !(piece = receive()).empty();) all += piece;
    return all;
  }
  /// Whether the other side has gone (or sent something) within the patience.
  [[nodiscard]] bool is_left() const { return receive(1).empty(); }

  void close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  /// Goes as a program does that is killed: at once, and with a reset.
  void reset() {
    const linger at_once{1, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    close();
  }

 private:
  int socket_ = -1;
};

/// Listens on 127.0.0.1 at a port that the system chooses, or at one that was had before.
class NetListener {
 public:
  explicit NetListener(int port = 0) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int on = 1;
    ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_port = htons(static_cast<std::uint16_t>(port));
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    if (::bind(socket_, reinterpret_cast<const sockaddr*>(&at), size) != 0 || ::listen(socket_, 8) != 0 ||
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&at), &size) != 0) {
      throw std::runtime_error("cannot listen on loopback");
    }
    port_ = ntohs(at.sin_port);
  }
  NetListener(const NetListener&) = delete;
  NetListener& operator=(const NetListener&) = delete;
  ~NetListener() { ::close(socket_); }

  [[nodiscard]] int port() const noexcept { return port_; }
  /// Whoever dials; none if nobody does.
  [[nodiscard]] NetPeer accept(int patience_ms = kPeerPatienceMs) const {
    pollfd asked{socket_, POLLIN, 0};
    if (::poll(&asked, 1, patience_ms) <= 0) return {};
    return NetPeer(::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC));
  }

 private:
  int socket_;
  int port_ = 0;
};

/// A port of loopback that nobody listens at: it was free a moment ago.
inline int free_port() { return NetListener().port(); }

}  // namespace odas::test
