// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

#include "odas/engine/latest.hpp"
#include "odas/engine/metrics.hpp"

namespace odas {

/// The metrics of a run while it goes on, for one who looks at them now and then. Nobody locks and nobody
/// waits: the engine's thread leaves a copy of its figures every few hops.
class LiveMetrics {
 public:
  /// Hops between two copies: a quarter of a second or so.
  static constexpr std::uint64_t kPeriod = 32;

  /// Engine's thread.
  void note_engine(const Metrics& engine) noexcept { engine_.put(engine); }
  /// Source's thread.
  void note_source(std::uint64_t overruns, std::uint64_t lost_frames) noexcept {
    overruns_.store(overruns, std::memory_order_relaxed);
    lost_frames_.store(lost_frames, std::memory_order_relaxed);
  }

  /// One thread at a time.
  [[nodiscard]] Metrics read() {
    Metrics metrics = engine_.get();
    metrics.overruns = overruns_.load(std::memory_order_relaxed);
    metrics.lost_frames = lost_frames_.load(std::memory_order_relaxed);
    return metrics;
  }

 private:
  Latest<Metrics> engine_;
  std::atomic<std::uint64_t> overruns_{0}, lost_frames_{0};
};

}  // namespace odas
