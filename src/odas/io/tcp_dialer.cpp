// SPDX-License-Identifier: MIT
#include "odas/io/tcp_dialer.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>

namespace odas {
namespace {

std::string message(int number) { return std::generic_category().message(number); }

}  // namespace

std::optional<FileDescriptor> TcpDialer::poll(Clock::time_point now) {
  if (!dialling_.open()) begin_next(now);
  return dialling_.open() ? finish(now) : std::nullopt;
}

void TcpDialer::begin_next(Clock::time_point now) {
  if (untried_.empty()) {
    if (now < next_) return;
    if (!lookup_) lookup_.emplace(host_, port_);
    std::optional<NetAddresses> answer = lookup_->poll();
    if (!answer) return;
    lookup_.reset();
    if (!answer->fault.empty()) return fail(answer->fault, now);
    untried_.assign(answer->all.rbegin(), answer->all.rend());
  }
  const NetAddress address = untried_.back();
  untried_.pop_back();
  FileDescriptor socket(::socket(address.family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket.open()) return fail(message(errno), now);
  const int on = 1;
  ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  if (::connect(socket.get(), address.get(), address.length) != 0 && errno != EINPROGRESS) {
    return fail(message(errno), now);
  }
  dialling_ = std::move(socket);
  began_ = now;
}

std::optional<FileDescriptor> TcpDialer::finish(Clock::time_point now) {
  pollfd asked{dialling_.get(), POLLOUT, 0};
  if (::poll(&asked, 1, 0) <= 0) {
    if (now - began_ > kPatience) fail("no answer", now);
    return std::nullopt;
  }
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(dialling_.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) {
    fail(message(error), now);
    return std::nullopt;
  }
  fault_.clear();
  untried_.clear();
  pause_ = kFirstPause;
  next_ = now + pause_;  // a peer that answers and goes away at once must not keep us busy
  return std::exchange(dialling_, FileDescriptor());
}

void TcpDialer::fail(const std::string& why, Clock::time_point now) {
  dialling_ = FileDescriptor();
  fault_ = why;
  if (!untried_.empty()) return;
  next_ = now + pause_;
  pause_ = std::min<Clock::duration>(2 * pause_, kLongestPause);
}

}  // namespace odas
