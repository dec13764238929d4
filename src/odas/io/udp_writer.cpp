// SPDX-License-Identifier: MIT
#include "odas/io/udp_writer.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/socket.h>

namespace odas {
namespace {

constexpr std::chrono::seconds kLookupPause{3};

}  // namespace

UdpWriter::UdpWriter(std::string host, int port, std::function<void(const std::string&)> say)
    : host_(std::move(host)), port_(port), say_(std::move(say)) {
  find_peer();
}

UdpWriter::UdpWriter(std::string host, std::vector<NetAddress> addresses,
                     std::function<void(const std::string&)> say)
    : host_(std::move(host)),
      port_(addresses.front().port()),
      say_(std::move(say)),
      addresses_(std::move(addresses)) {
  connect_first();
}

void UdpWriter::find_peer() {
  if (socket_.open()) return;
  if (!lookup_) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_lookup_) return;
    next_lookup_ = now + kLookupPause;
    lookup_.emplace(host_, port_, SOCK_DGRAM);
  }
  std::optional<NetAddresses> answer = lookup_->poll();
  if (!answer) return;
  lookup_.reset();
  if (!answer->fault.empty()) return tell_once(answer->fault);
  addresses_ = std::move(answer->all);
  next_ = 0;
  connect_first();
}

void UdpWriter::connect_first() {
  for (std::size_t tried = 0; tried < addresses_.size() && !socket_.open(); ++tried) connect_next();
}

/// Of UDP this only says whether there is a way to him, and sends nothing.
void UdpWriter::connect_next() {
  const NetAddress& peer = addresses_[next_];
  next_ = (next_ + 1) % addresses_.size();
  FileDescriptor socket(::socket(peer.family(), SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (socket.open() && ::connect(socket.get(), peer.get(), peer.length) == 0) {
    socket_ = std::move(socket);
  } else if (const int error = errno; !socket_.open() && next_ == 0) {
    tell_once(std::generic_category().message(error));
  }
}

IoStatus UdpWriter::write(std::span<const char> record) {
  find_peer();
  if (!socket_.open()) {
    ++lost_;
    return {};
  }
  if (::send(socket_.get(), record.data(), record.size(), MSG_NOSIGNAL) >= 0) return {};
  ++lost_;
  // Refused: the answer to an earlier datagram, that nobody listens now. It is no fault of the sender's;
  // perhaps he listens at another of his addresses.
  if (errno == ECONNREFUSED) {
    if (addresses_.size() > 1) connect_next();
  } else {
    tell_once(std::generic_category().message(errno));
  }
  return {};
}

void UdpWriter::tell_once(const std::string& why) {
  if (!std::exchange(told_, true) && say_) say_("cannot send to " + where() + ": " + why);
}

}  // namespace odas
