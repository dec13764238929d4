// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

namespace odas {

/// Records on their way to a reader who may be slow: each goes in whole or not at all, and comes out in
/// pieces of any size. So a reader who falls behind loses whole hops, and never a part of one.
class RecordQueue {
 public:
  /// Bytes that may wait: seconds of text, and of most sound.
  static constexpr std::size_t kRoom = std::size_t{1} << 20;

  explicit RecordQueue(std::size_t room = kRoom) : room_(room) {}

  /// False: there is no room, and nothing of it was taken. An empty queue takes a record of any size.
  [[nodiscard]] bool put(std::span<const char> record);

  [[nodiscard]] bool has_room(std::size_t bytes) const noexcept {
    return empty() || bytes_.size() - sent_ + bytes <= room_;
  }

  /// What is next to be sent; empty: nothing.
  [[nodiscard]] std::span<const char> front() const noexcept { return std::span(bytes_).subspan(sent_); }
  /// So many bytes of the front have gone.
  void pop(std::size_t count);

  [[nodiscard]] bool empty() const noexcept { return sent_ == bytes_.size(); }
  /// Records that have not gone to their last byte.
  [[nodiscard]] std::size_t records() const noexcept { return sizes_.size(); }

 private:
  std::size_t room_;
  std::vector<char> bytes_;  // from sent_ on: what waits
  std::size_t sent_ = 0;
  std::deque<std::size_t> sizes_;  // bytes still to go of each record
};

}  // namespace odas
