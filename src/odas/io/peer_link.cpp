// SPDX-License-Identifier: MIT
#include "odas/io/peer_link.hpp"

#include <array>
#include <cerrno>

#include <poll.h>
#include <sys/socket.h>

namespace odas {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kStepMs = 20;

/// Waits until the peer takes something, or a step is over.
void wait_for(int socket) {
  pollfd asked{socket, POLLOUT, 0};
  ::poll(&asked, 1, kStepMs);
}

bool is_patience(int number) { return number == EAGAIN || number == EWOULDBLOCK || number == EINTR; }

}  // namespace

bool PeerLink::put(std::span<const char> record) {
  if (queue_.put(record)) {
    behind_ = 0;
    return true;
  }
  ++lost_;
  ++behind_;
  return false;
}

bool PeerLink::discard_input() {
  std::array<char, 4096> ignored{};
  for (int i = 0; i < 16; ++i) {
    const ssize_t count = ::recv(socket_.get(), ignored.data(), ignored.size(), MSG_DONTWAIT);
    if (count < 0) return is_patience(errno);
    if (count == 0) {
      has_finished_ = true;
      return true;
    }
  }
  return true;
}

bool PeerLink::send_some() {
  if (!has_finished_ && !discard_input()) return false;
  while (!queue_.empty()) {
    const std::span<const char> front = queue_.front();
    const ssize_t sent = ::send(socket_.get(), front.data(), front.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0) return is_patience(errno);
    queue_.pop(static_cast<std::size_t>(sent));
  }
  asleep_ = false;
  return true;
}

bool PeerLink::make_room(std::size_t bytes, const PeerManners& manners) {
  auto moved = Clock::now();
  std::size_t left = queue_.front().size();
  while (!queue_.has_room(bytes) && !asleep_) {
    wait_for(socket_.get());
    if (!send_some()) return false;
    const auto now = Clock::now();
    if (queue_.front().size() < left) moved = now;
    left = queue_.front().size();
    if (now - moved > manners.patience || manners.stopped()) asleep_ = true;
  }
  return true;
}

void PeerLink::finish(std::chrono::milliseconds patience) {
  auto moved = Clock::now();
  std::size_t left = queue_.front().size();
  bool there = send_some();
  while (there && !queue_.empty() && Clock::now() - moved < patience) {
    wait_for(socket_.get());
    there = send_some();
    if (queue_.front().size() < left) moved = Clock::now();
    left = queue_.front().size();
  }
  lose_the_rest();
  ::shutdown(socket_.get(), SHUT_WR);
  discard_input();
}

}  // namespace odas
