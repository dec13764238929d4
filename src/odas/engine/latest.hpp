// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace odas {

/// The latest of the values that one thread puts, for one other thread: neither waits, and what nobody took
/// in time is forgotten.
///
/// Method: three places. One is the writer's, one the reader's; the third changes hands.
template <class T>
class Latest {
 public:
  /// Writer.
  void put(const T& value) noexcept {
    places_[writer_] = value;
    writer_ = between_.exchange(writer_ | kFresh, std::memory_order_acq_rel) & ~kFresh;
  }
  /// Reader. T{} until the first put.
  [[nodiscard]] const T& get() noexcept {
    if ((between_.load(std::memory_order_relaxed) & kFresh) != 0) {
      reader_ = between_.exchange(reader_, std::memory_order_acq_rel) & ~kFresh;
    }
    return places_[reader_];
  }

 private:
  static constexpr std::uint32_t kFresh = 4;
  std::array<T, 3> places_{};
  std::uint32_t writer_ = 0;
  std::atomic<std::uint32_t> between_{1};
  std::uint32_t reader_ = 2;
};

}  // namespace odas
