// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "odas/pipeline/stage_watch.hpp"

namespace odas {

/// How long hops took: a histogram of fixed size, four bins an octave from 1 us on, so that a quantile is
/// right within a fifth.
class TimeHistogram {
 public:
  void add(std::chrono::nanoseconds time) noexcept;

  /// Upper edge of the bin that holds the share `q` of all times. Zero where there are none.
  [[nodiscard]] std::chrono::nanoseconds quantile(double q) const noexcept;
  [[nodiscard]] std::chrono::nanoseconds max() const noexcept { return max_; }
  [[nodiscard]] std::chrono::nanoseconds total() const noexcept { return total_; }
  /// Of those times alone that came after `earlier`, a copy of this one; its longest is that of all times.
  [[nodiscard]] TimeHistogram since(const TimeHistogram& earlier) const noexcept;

 private:
  std::array<std::uint64_t, 128> bins_{};
  std::chrono::nanoseconds max_{0};
  std::chrono::nanoseconds total_{0};
};

/// What a run has cost, and what went wrong in small.
struct Metrics {
  std::uint64_t hops = 0;
  double sound_seconds = 0;              // of sound processed
  TimeHistogram hop_time;                // of the engine's thread
  StageTimes stage_times{};              // of the same
  std::uint64_t dropped_hops = 0;        // that a sink was too slow for
  std::uint64_t lost_records = 0;        // hops (of audio: blocks) that the peers of outputs did not get
  std::uint64_t overruns = 0;            // blocks of a live source that the engine was too slow for
  std::uint64_t lost_frames = 0;         // of the source, in these blocks and before they reached us
  std::uint64_t skipped_hops = 0;        // stamps without a hop, for what was lost
  std::uint64_t clipped_samples = 0;     // of the output
  std::uint64_t non_finite_samples = 0;  // of the input, taken as silence
  double echo_return_loss_db = 0;        // of the last seconds in which the machine was heard; 0: none

  /// Share of real time that the engine's thread was busy.
  [[nodiscard]] double real_time_share() const noexcept;
};

}  // namespace odas
