// SPDX-License-Identifier: MIT
#include "odas/io/terminal_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <system_error>

#include <poll.h>
#include <unistd.h>

namespace odas {
namespace {

constexpr int kWritePatienceMs = 100;
// A pipe that poll() calls writable takes as much without waiting.
constexpr std::size_t kPiece = PIPE_BUF;

}  // namespace

IoStatus TerminalWriter::write(std::span<const char> record) {
  if (!queue_.put(record)) ++lost_;
  return send(waits_ && !stopped() ? kWritePatienceMs : 0);
}

IoStatus TerminalWriter::close() {
  IoStatus status = send(kWritePatienceMs);
  lost_ += queue_.records();
  return status;
}

bool TerminalWriter::stopped() const noexcept {
  return stop_ != nullptr && stop_->load(std::memory_order_relaxed);
}

IoStatus TerminalWriter::send(int patience_ms) {
  while (!queue_.empty()) {
    pollfd waiting{descriptor_, POLLOUT, 0};
    if (::poll(&waiting, 1, patience_ms) == 0) {
      if (!waits_ || stopped()) return {};
      continue;
    }
    const std::span<const char> front = queue_.front();
    const ssize_t n = ::write(descriptor_, front.data(), std::min(front.size(), kPiece));
    if (n >= 0) {
      queue_.pop(static_cast<std::size_t>(n));
    } else if (errno == EPIPE) {
      return IoStatus::failed("nobody reads it any more: the program behind the pipe has ended");
    } else if (errno != EINTR && errno != EAGAIN) {
      return IoStatus::failed("cannot write: " + std::generic_category().message(errno));
    }
  }
  return {};
}

}  // namespace odas
