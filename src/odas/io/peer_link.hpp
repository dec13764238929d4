// SPDX-License-Identifier: MIT
// What the writers to sockets share.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "odas/io/file_descriptor.hpp"
#include "odas/io/record_queue.hpp"

namespace odas {

/// How a writer treats those who read from it.
struct PeerManners {
  /// A recording can wait for a reader who is slow, as ODAS does: for so long at a time that nothing moves.
  /// Zero, for a live source: nobody waits.
  std::chrono::milliseconds patience{0};
  /// Set when the run is to end: then nobody waits any more.
  const std::atomic<bool>* stop = nullptr;
  /// Told who comes, goes and falls behind. May be empty.
  std::function<void(const std::string&)> say{};

  [[nodiscard]] bool stopped() const noexcept {
    return stop != nullptr && stop->load(std::memory_order_relaxed);
  }
};

/// A connection that records go out on, and that never makes its owner wait unless he asks for it. What the
/// peer says is read and thrown away: left unread, it would break the connection at its end.
class PeerLink {
 public:
  explicit PeerLink(FileDescriptor socket, std::size_t room = RecordQueue::kRoom)
      : socket_(std::move(socket)), queue_(room) {}

  /// Takes a record, whole, or loses it.
  bool put(std::span<const char> record);
  /// Sends what the peer takes now. False: he has gone.
  [[nodiscard]] bool send_some();
  /// Waits until there is room for `bytes`, as long as the peer takes something every `patience`.
  [[nodiscard]] bool make_room(std::size_t bytes, const PeerManners& manners);
  /// Sends the rest, and tells the peer that there will be no more; waits at most `patience` for each step.
  void finish(std::chrono::milliseconds patience);

  /// The peer has said his last. One who only reads may have done so and still be there.
  [[nodiscard]] bool has_finished() const noexcept { return has_finished_; }
  /// Records that had no room since the last one that had.
  [[nodiscard]] std::uint64_t behind() const noexcept { return behind_; }
  /// Records that are lost for this peer: those without room, and, once he has gone, those that waited.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  void lose_the_rest() noexcept { lost_ += queue_.records(); }
  [[nodiscard]] int descriptor() const noexcept { return socket_.get(); }

 private:
  /// False: the connection is broken.
  bool discard_input();

  FileDescriptor socket_;
  RecordQueue queue_;
  std::uint64_t lost_ = 0, behind_ = 0;
  bool has_finished_ = false;
  bool asleep_ = false;  // patience has run out once: it comes back when everything has been sent
};

/// Grace at the end of a run, for a peer who still reads.
inline constexpr std::chrono::milliseconds kFarewell{1000};

}  // namespace odas
