// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// A new pipeline on its way to the engine's thread, which puts it into the place of the running one between
/// two hops. It is made, and the old one is taken down, by the sender: the engine only swaps.
class PipelineInbox {
 public:
  PipelineInbox() = default;
  ~PipelineInbox() {
    delete next_.load();
    delete old_.load();
  }
  PipelineInbox(const PipelineInbox&) = delete;
  PipelineInbox& operator=(const PipelineInbox&) = delete;

  /// Sender: `next` can continue what runs (`Pipeline::can_continue`). One that the engine has not taken yet
  /// is replaced.
  void post(std::unique_ptr<Pipeline> next) {
    const Pipeline* const unseen = next_.exchange(next.release(), std::memory_order_acq_rel);
    if (unseen == nullptr) ++posted_;
    delete unseen;
  }
  /// Sender, now and then: takes the old one down. True: the engine has put the last one into its place, and
  /// leaves what runs alone until the next.
  bool tidy() {
    delete old_.exchange(nullptr, std::memory_order_acq_rel);
    return taken_.load(std::memory_order_acquire) == posted_;
  }

  /// Engine, before a hop. While an old one waits to be taken down, a new one waits.
  void deliver(Pipeline& running) noexcept {
    if (next_.load(std::memory_order_relaxed) == nullptr) return;
    if (old_.load(std::memory_order_acquire) != nullptr) return;
    Pipeline* next = next_.exchange(nullptr, std::memory_order_acq_rel);
    if (next == nullptr) return;
    next->continue_from(running);
    std::swap(*next, running);
    old_.store(next, std::memory_order_release);
    taken_.fetch_add(1, std::memory_order_release);
  }

 private:
  std::atomic<Pipeline*> next_{nullptr};
  std::atomic<Pipeline*> old_{nullptr};
  std::uint64_t posted_ = 0;  // sender's
  std::atomic<std::uint64_t> taken_{0};
};

}  // namespace odas
