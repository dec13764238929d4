// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "odas/base/contract.hpp"

namespace odas {

/// A bounded queue between one producer thread and one consumer thread, without locks. Its elements are made
/// once and are written and read in place, so that passing a hop on allocates nothing.
///
///     if (Hop* hop = queue.begin_push()) { ...fill *hop...; queue.end_push(); }
///     if (Hop* hop = queue.front()) { ...read *hop...; queue.pop(); }
template <class T>
class SpscQueue {
 public:
  /// Each element starts as a copy of `element`: of its full size already.
  SpscQueue(std::size_t capacity, const T& element) : elements_(capacity, element) {
    ODAS_EXPECT(capacity > 0);
  }

  [[nodiscard]] std::size_t capacity() const noexcept { return elements_.size(); }

  /// Producer: the element to fill next, or nullptr where the queue is full.
  [[nodiscard]] T* begin_push() noexcept {
    const std::uint32_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_.load(std::memory_order_acquire) == elements_.size()) return nullptr;
    return &elements_[write_];
  }
  /// Producer: hands over the element that begin_push() gave.
  void end_push() noexcept {
    if (++write_ == elements_.size()) write_ = 0;
    tail_.fetch_add(1, std::memory_order_release);
    tail_.notify_one();
  }
  /// Producer: sleeps until there is room.
  [[nodiscard]] T& wait_push() noexcept {
    for (;;) {
      const std::uint32_t head = head_.load(std::memory_order_acquire);
      if (T* element = begin_push()) return *element;
      head_.wait(head, std::memory_order_acquire);
    }
  }

  /// Consumer: the oldest element, or nullptr where the queue is empty.
  [[nodiscard]] T* front() noexcept {
    const std::uint32_t head = head_.load(std::memory_order_relaxed);
    if (tail_.load(std::memory_order_acquire) == head) return nullptr;
    return &elements_[read_];
  }
  /// Consumer: gives the element that front() gave back to the producer.
  void pop() noexcept {
    if (++read_ == elements_.size()) read_ = 0;
    head_.fetch_add(1, std::memory_order_release);
    head_.notify_one();
  }
  /// Consumer: sleeps until there is an element.
  [[nodiscard]] T& wait_front() noexcept {
    for (;;) {
      const std::uint32_t tail = tail_.load(std::memory_order_acquire);
      if (T* element = front()) return *element;
      tail_.wait(tail, std::memory_order_acquire);
    }
  }

 private:
  // Counters of all pushes and pops; they wrap, their difference does not. Each on its own cache line, beside
  // what only the same thread uses.
  alignas(64) std::atomic<std::uint32_t> tail_{0};
  std::size_t write_ = 0;  // producer's
  alignas(64) std::atomic<std::uint32_t> head_{0};
  std::size_t read_ = 0;  // consumer's
  alignas(64) std::vector<T> elements_;
};

}  // namespace odas
