// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>

#include "odas/base/spsc_queue.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// Fixed directions on their way from one sender's thread to the engine's, which takes them between two hops.
class TargetInbox {
 public:
  /// Sender: from the next hop on these are the targets. False while the engine has not taken those before:
  /// try again.
  [[nodiscard]] bool post(const TargetList& targets) noexcept {
    TargetList* place = queue_.begin_push();
    if (place == nullptr) return false;
    *place = targets;
    queue_.end_push();
    return true;
  }
  /// Sender: targets without a track as of the last hop, for want of a slot.
  [[nodiscard]] std::size_t unfollowed() const noexcept {
    return unfollowed_.load(std::memory_order_relaxed);
  }

  /// Engine, before a hop.
  void deliver(Pipeline& pipeline) noexcept {
    while (const TargetList* targets = queue_.front()) {
      pipeline.set_targets(targets->view());
      queue_.pop();
    }
  }
  /// Engine, after a hop.
  void note(const Pipeline& pipeline) noexcept {
    unfollowed_.store(pipeline.unfollowed_targets(), std::memory_order_relaxed);
  }

 private:
  static constexpr std::size_t kLength = 4;
  SpscQueue<TargetList> queue_{kLength, TargetList()};
  std::atomic<std::size_t> unfollowed_{0};
};

}  // namespace odas
