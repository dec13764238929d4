// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>

#include "odas/base/spsc_queue.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// Fixed directions, and muted ones, on their way from those who give them to the engine's thread, which
/// takes them between two hops. Any number of threads may give them: each changes what holds.
class TargetInbox {
 public:
  struct Orders {
    TargetList targets;  // followed
    TargetList muted;
  };

  /// `begin`: the targets that the pipeline begins with.
  explicit TargetInbox(const TargetList& begin = {}) { orders_.targets = begin; }

  /// Sender: what holds from the next hop on is what `edit(Orders&)` makes of what held before.
  template <class Edit>
  void change(Edit&& edit) {
    const std::lock_guard lock(senders_);
    edit(orders_);
    post();
  }
  /// Sender: what holds.
  [[nodiscard]] Orders orders() const {
    const std::lock_guard lock(senders_);
    return orders_;
  }
  /// Sender: the engine may have been too far behind to take the last orders. To be called now and then.
  void retry() {
    const std::lock_guard lock(senders_);
    if (waiting_) post();
  }
  /// Sender: targets without a track as of the last hop, for want of a slot.
  [[nodiscard]] std::size_t unfollowed() const noexcept {
    return unfollowed_.load(std::memory_order_relaxed);
  }

  /// Engine, before a hop.
  void deliver(Pipeline& pipeline) noexcept {
    while (const Orders* orders = queue_.front()) {
      pipeline.set_targets(orders->targets.view());
      pipeline.set_muted(orders->muted.view());
      queue_.pop();
    }
  }
  /// Engine, after a hop.
  void note(const Pipeline& pipeline) noexcept {
    unfollowed_.store(pipeline.unfollowed_targets(), std::memory_order_relaxed);
  }

 private:
  void post() {
    Orders* place = queue_.begin_push();
    waiting_ = place == nullptr;
    if (waiting_) return;
    *place = orders_;
    queue_.end_push();
  }

  static constexpr std::size_t kLength = 4;
  mutable std::mutex senders_;
  Orders orders_;         // guarded by senders_
  bool waiting_ = false;  // guarded by senders_: the queue was full
  SpscQueue<Orders> queue_{kLength, Orders()};
  std::atomic<std::size_t> unfollowed_{0};
};

}  // namespace odas
