// SPDX-License-Identifier: MIT
#include "odas/io/stream_port.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::size_t kCandidates = 8;
constexpr auto kTokenPatience = std::chrono::seconds(5);  // for a token

void add(std::string& notice, const std::string& text) { notice += (notice.empty() ? "" : "; ") + text; }

/// So that a peer whose cable is pulled is missed within half a minute.
void keep_alive(int socket) {
  const auto set = [&](int level, int option, int value) {
    ::setsockopt(socket, level, option, &value, sizeof value);
  };
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, 10);
  set(IPPROTO_TCP, TCP_KEEPINTVL, 5);
  set(IPPROTO_TCP, TCP_KEEPCNT, 3);
}

}  // namespace

std::optional<FileDescriptor> DialPort::poll(std::string& notice) {
  std::optional<FileDescriptor> socket = dialer_.poll();
  if (socket) {
    keep_alive(socket->get());
    if (std::exchange(said_, false)) add(notice, "connected to " + where());
  } else if (!dialer_.fault().empty() && !std::exchange(said_, true)) {
    add(notice, "cannot reach " + where() + " yet: " + dialer_.fault() + "; it is dialled until it answers");
  }
  return socket;
}

ListenPort::ListenPort(const std::string& host, int port, std::string token)
    : listener_(host, port), token_(std::move(token)) {}

bool ListenPort::hear(Candidate& candidate) {
  const int socket = candidate.client.socket.get();
  std::array<char, 256> bytes;
  while (candidate.gate.state() == TokenGate::State::waiting) {
    // Looked at first and taken then: what comes after the token's line is sound.
    const ssize_t seen = ::recv(socket, bytes.data(), bytes.size(), MSG_PEEK | MSG_DONTWAIT);
    if (seen < 0 && (errno == EAGAIN || errno == EINTR)) return Clock::now() > candidate.until;
    if (seen <= 0) return true;
    std::size_t used = 0;
    candidate.gate.push({bytes.data(), static_cast<std::size_t>(seen)}, used);
    if (::recv(socket, bytes.data(), used, MSG_DONTWAIT) != static_cast<ssize_t>(used)) return true;
  }
  return candidate.gate.state() == TokenGate::State::refused;
}

std::optional<FileDescriptor> ListenPort::poll(std::string& notice) {
  if (!std::exchange(said_, true)) add(notice, "waiting for a sender at " + where());
  while (auto client = listener_.accept()) {
    if (candidates_.size() == kCandidates) continue;  // it is closed
    candidates_.push_back({std::move(*client), TokenGate(token_), Clock::now() + kTokenPatience});
  }
  for (auto at = candidates_.begin(); at != candidates_.end();) {
    if (hear(*at)) {
      if (at->gate.state() == TokenGate::State::refused) {
        add(notice, at->client.from + " was turned away: it did not begin with the token");
      }
      at = candidates_.erase(at);
    } else if (at->gate.state() == TokenGate::State::granted) {
      add(notice, "receiving from " + at->client.from);
      FileDescriptor socket = std::move(at->client.socket);
      keep_alive(socket.get());
      candidates_.clear();
      said_ = said_busy_ = false;
      return socket;
    } else {
      ++at;
    }
  }
  return std::nullopt;
}

void ListenPort::refuse_others(std::string& notice) {
  while (const auto client = listener_.accept()) {
    // Said once a sender: who knocks all day long must not fill a log.
    if (std::exchange(said_busy_, true)) continue;
    add(notice, client->from + " was turned away: there is a sender already");
  }
}

StdinPort::StdinPort() : input_(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)) {
  if (!input_.open()) throw IoError("standard input is closed: there is nothing to listen to");
  if (::isatty(input_.get()) == 1) {
    throw IoError("standard input is a terminal; pipe the sound in: arecord ... -t raw | odas live ...");
  }
}

std::optional<FileDescriptor> StdinPort::poll(std::string&) {
  if (!input_.open()) return std::nullopt;
  return std::exchange(input_, FileDescriptor());
}

}  // namespace odas
