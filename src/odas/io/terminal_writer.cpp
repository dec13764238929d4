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

constexpr int kPatienceMs = 100;
// A pipe that poll() calls writable takes as much without waiting.
constexpr std::size_t kPiece = PIPE_BUF;

}  // namespace

IoStatus TerminalWriter::write(std::span<const char> record) {
  while (!record.empty() && !gave_up_) {
    pollfd waiting{descriptor_, POLLOUT, 0};
    if (::poll(&waiting, 1, kPatienceMs) == 0) {
      gave_up_ = stop_ != nullptr && stop_->load(std::memory_order_relaxed);
      continue;
    }
    const ssize_t n = ::write(descriptor_, record.data(), std::min(record.size(), kPiece));
    if (n >= 0) {
      record = record.subspan(static_cast<std::size_t>(n));
    } else if (errno == EPIPE) {
      return IoStatus::failed("nobody reads it any more: the program behind the pipe has ended");
    } else if (errno != EINTR && errno != EAGAIN) {
      return IoStatus::failed("cannot write: " + std::generic_category().message(errno));
    }
  }
  return {};
}

}  // namespace odas
