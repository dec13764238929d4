// SPDX-License-Identifier: MIT
#include "odas/io/tcp_listener.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <netinet/in.h>
#include <netinet/tcp.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr int kBacklog = 16;

std::string advice(int number) {
  switch (number) {
    case EADDRINUSE:
      return "; another program listens there: end it, or choose another port";
    case EACCES:
      return "; ports below 1024 need privileges: choose a higher one";
    case EADDRNOTAVAIL:
      return "; it is no address of this machine: 127.0.0.1 is, and 0.0.0.0 is all of them";
    default:
      return "";
  }
}

void set_on(int socket, int level, int option) {
  const int on = 1;
  ::setsockopt(socket, level, option, &on, sizeof on);
}

}  // namespace

TcpListener::TcpListener(const std::string& host, int port) {
  const std::string name = host.empty() ? "127.0.0.1" : host;
  NetAddresses addresses = look_up(name, port);
  if (!addresses.fault.empty()) {
    throw IoError("cannot listen at " + host_and_port(name, port) + ": " + addresses.fault);
  }
  // Of a name's addresses those of IPv4 first: who dials the name tries all, who dials a number means IPv4.
  std::stable_partition(addresses.all.begin(), addresses.all.end(),
                        [](const NetAddress& address) { return address.family() == AF_INET; });
  int first_error = 0;
  for (const NetAddress& address : addresses.all) {
    const int error = listen_at(address);
    if (error == 0) break;
    if (first_error == 0) first_error = error;
  }
  if (!socket_.open()) {
    throw IoError("cannot listen at " + host_and_port(name, port) + ": " +
                  std::generic_category().message(first_error) + advice(first_error));
  }
  NetAddress bound;
  bound.length = sizeof bound.storage;
  ::getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&bound.storage), &bound.length);
  port_ = bound.port();
  where_ = host_and_port(name, port_);
}

int TcpListener::listen_at(const NetAddress& address) {
  FileDescriptor socket(::socket(address.family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (socket.open()) set_on(socket.get(), SOL_SOCKET, SO_REUSEADDR);
  if (!socket.open() || ::bind(socket.get(), address.get(), address.length) != 0 ||
      ::listen(socket.get(), kBacklog) != 0) {
    return errno;
  }
  socket_ = std::move(socket);
  return 0;
}

std::optional<TcpClient> TcpListener::accept() {
  NetAddress peer;
  peer.length = sizeof peer.storage;
  FileDescriptor socket(::accept4(socket_.get(), reinterpret_cast<sockaddr*>(&peer.storage), &peer.length,
                                  SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!socket.open()) return std::nullopt;
  set_on(socket.get(), IPPROTO_TCP, TCP_NODELAY);
  return TcpClient{std::move(socket), peer.text(), peer};
}

TokenGate::TokenGate(std::string token)
    : token_(std::move(token)), state_(token_.empty() ? State::granted : State::waiting) {}

TokenGate::State TokenGate::push(std::string_view bytes, std::size_t& used) {
  used = 0;
  if (state_ != State::waiting) return state_;
  const std::size_t end = bytes.find('\n');
  used = end == std::string_view::npos ? bytes.size() : end + 1;
  line_ += bytes.substr(0, std::min(used, token_.size() + 2 - std::min(line_.size(), token_.size() + 2)));
  if (end == std::string_view::npos) {
    if (line_.size() > token_.size() + 1) state_ = State::refused;
    return state_;
  }
  while (!line_.empty() && (line_.back() == '\n' || line_.back() == '\r')) line_.pop_back();
  unsigned differences = line_.size() == token_.size() ? 0 : 1;
  for (std::size_t i = 0; i < token_.size(); ++i) {
    const char said = i < line_.size() ? line_[i] : '\0';
    differences |= static_cast<unsigned char>(said ^ token_[i]);
  }
  state_ = differences == 0 ? State::granted : State::refused;
  return state_;
}

}  // namespace odas
