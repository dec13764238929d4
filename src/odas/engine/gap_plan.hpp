// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace odas {

/// How frames that the source has lost are bridged: a little silence, in which what the pipeline still holds
/// runs out, and then whole hops that are stepped over. What is no whole hop is more silence, and the part of
/// a frame that two rates leave is carried to the next gap: stamps are right to a frame, however many gaps.
class GapPlan {
 public:
  /// `run_out`: hops of silence before any hop is stepped over.
  GapPlan(int source_rate, int rate, std::size_t hop, std::uint64_t run_out) noexcept
      : frame_(static_cast<std::uint64_t>(rate)),
        hop_(static_cast<std::uint64_t>(source_rate) * hop),
        run_out_(run_out) {}

  struct Step {
    std::uint64_t silence = 0;  // frames of the source, first
    std::uint64_t hops = 0;     // to step over, then
  };
  [[nodiscard]] Step bridge(std::uint64_t lost) noexcept {
    owed_ += lost * frame_;
    Step step;
    step.hops = owed_ / hop_ - std::min(owed_ / hop_, run_out_);
    owed_ -= step.hops * hop_;
    step.silence = owed_ / frame_;
    owed_ -= step.silence * frame_;
    return step;
  }

 private:
  // Time in units of 1 / (source_rate * rate) seconds, in which frames and hops are whole numbers.
  std::uint64_t frame_;  // a frame of the source
  std::uint64_t hop_;
  std::uint64_t run_out_;
  std::uint64_t owed_ = 0;
};

}  // namespace odas
