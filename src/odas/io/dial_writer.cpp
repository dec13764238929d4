// SPDX-License-Identifier: MIT
#include "odas/io/dial_writer.hpp"

#include <poll.h>

namespace odas {

DialWriter::DialWriter(const std::string& host, int port, PeerManners manners)
    : dialer_(host, port), manners_(std::move(manners)) {
  step();
}

IoStatus DialWriter::write(std::span<const char> record) {
  step();
  if (!answered_) await_first_answer();
  if (link_ && manners_.patience.count() > 0 && !link_->make_room(record.size(), manners_)) step();
  if (!link_) {
    ++lost_;
    ++absent_;
    return {};
  }
  const bool was_behind = behind_ > 0;
  const bool taken = link_->put(record);
  if (!taken && !was_behind) say(where() + " does not read: whole hops are lost until it does");
  if (taken && was_behind) say(where() + " reads again; " + std::to_string(behind_) + " hops are lost");
  behind_ = link_->behind();
  step();
  return {};
}

void DialWriter::step() {
  if (!link_) {
    std::optional<FileDescriptor> socket = dialer_.poll();
    if (!socket) {
      if (!dialer_.fault().empty() && !told_absent_) {
        say("nobody answers at " + where() + " (" + dialer_.fault() + "); dialling again and again");
        told_absent_ = true;
      }
      return;
    }
    link_.emplace(std::move(*socket));
    if (told_absent_) {
      say("connected to " + where() + (absent_ > 0 ? "; " + std::to_string(absent_) + " hops went by" : ""));
    }
    answered_ = true;
    told_absent_ = false;
    absent_ = behind_ = 0;
  }
  // Who listens has nothing to say: when he hangs up, he has gone.
  if (link_->send_some() && !link_->has_finished()) return;
  link_->lose_the_rest();
  lost_ += link_->lost();
  link_.reset();
  say(where() + " has gone; dialling again and again");
  told_absent_ = true;
}

void DialWriter::await_first_answer() {
  const auto until = TcpDialer::Clock::now() + manners_.patience;
  while (!link_ && dialer_.fault().empty() && TcpDialer::Clock::now() < until && !manners_.stopped()) {
    ::poll(nullptr, 0, 1);
    step();
  }
  answered_ = true;
}

IoStatus DialWriter::flush() {
  step();
  return {};
}

IoStatus DialWriter::close() {
  if (!link_) return {};
  link_->finish(kFarewell);
  lost_ += link_->lost();
  link_.reset();
  return {};
}

std::uint64_t DialWriter::lost_records() const noexcept { return lost_ + (link_ ? link_->lost() : 0); }

void DialWriter::say(const std::string& what) const {
  if (manners_.say) manners_.say(what);
}

}  // namespace odas
