// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>

#include <nlohmann/json_fwd.hpp>

#include "odas/engine/live_metrics.hpp"

namespace odas {

/// The figures of a run while it goes on: those of its engine, and those that its sinks have counted.
struct RunFigures {
  LiveMetrics engine;
  std::atomic<std::uint64_t> lost_records{0}, clipped_samples{0};
};

/// The figures of the message `health`, but for those of the server. Any thread.
class HealthFigures {
 public:
  /// Another run begins; nullptr: none goes on, and the last figures stay.
  void begin(std::shared_ptr<RunFigures> run);
  /// Hop times are those of the last ten seconds or so, the longest that of the run.
  [[nodiscard]] nlohmann::json read();

 private:
  using Clock = std::chrono::steady_clock;
  struct Look {
    Clock::time_point at;
    Metrics metrics;
  };
  [[nodiscard]] double cpu_share();

  std::mutex mutex_;
  std::shared_ptr<RunFigures> run_;
  std::deque<Look> looks_;  // about one a second
  Clock::time_point cpu_at_ = Clock::now();
  double cpu_seconds_ = 0;
  double cpu_share_ = 0;
};

/// This process, as Linux counts it. 0 where it does not say.
[[nodiscard]] double process_cpu_seconds();
[[nodiscard]] std::uint64_t resident_bytes();
/// The hottest sensor of the machine, degrees C; NaN: it has none.
[[nodiscard]] double temperature();

}  // namespace odas
