// SPDX-License-Identifier: MIT
// What every kind of run tells while it goes, and at its end.
#pragma once

#include "odas/engine/block_feed.hpp"
#include "odas/engine/hop_loop.hpp"
#include "odas/engine/sink_group.hpp"

namespace odas {

/// Tells what InputHealth has found, a few times a second of sound. In the thread of the caller.
class HealthWatch {
 public:
  HealthWatch(InputHealth& health, int sample_rate, BlockFeed& feed);
  void passed(std::size_t frames);

 private:
  InputHealth& health_;
  BlockFeed& feed_;
  std::size_t period_;  // frames
  std::size_t passed_ = 0;
};

/// Once all threads have ended: the metrics, and the last warnings.
void finish_summary(RunSummary& summary, HopLoop& loop, const SinkGroup& sinks, BlockFeed& feed);

}  // namespace odas
