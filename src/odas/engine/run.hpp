// SPDX-License-Identifier: MIT
// What every kind of run takes and gives.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odas/engine/live_metrics.hpp"
#include "odas/engine/metrics.hpp"
#include "odas/engine/pipeline_inbox.hpp"
#include "odas/engine/target_inbox.hpp"

namespace odas {

struct RunOptions {
  /// ODAS begins with one raw block of silence; its time stamps count it.
  bool silent_first_block = false;
  /// The last block of a recording, where it is not full: padded with silence up to a hop, or dropped (ODAS).
  bool pad_last_block = true;
  /// Set by somebody else (a signal, a button): the run ends well, with all files finished.
  const std::atomic<bool>* stop = nullptr;
  /// Whence fixed directions come and go while it runs; nullptr: those of the configuration hold.
  TargetInbox* targets = nullptr;
  /// Whence new pipelines come while it runs, to take the place of the one that does; nullptr: it stays.
  PipelineInbox* pipelines = nullptr;
  /// Where its metrics are left while it goes on (run_live only); nullptr: nobody looks.
  LiveMetrics* metrics = nullptr;
  /// Frames read so far, and of how many. Called for each block, in the thread of the caller.
  std::function<void(std::uint64_t done, std::optional<std::uint64_t> total)> progress;
  /// Told at once of what a user should know but what does not end the run: "microphone 3 (channel 4) is
  /// silent". Called in the thread of the caller.
  std::function<void(const std::string& warning)> warn;
  /// Told at once what the source has to say: "waiting for 127.0.0.1:9000". Called in the thread of the
  /// caller.
  std::function<void(const std::string& notice)> notice;
};

struct RunSummary {
  enum class End { end_of_input, stopped, source_failed, sink_failed };
  End end = End::end_of_input;
  std::string fault;                  // what failed, and what to do; empty unless it did
  std::vector<std::string> warnings;  // all of them, those told by `warn` too
  std::uint64_t frames = 0;           // read from the source
  Metrics metrics;

  /// 0: end of input, or asked to stop. 1: something failed.
  [[nodiscard]] int exit_code() const noexcept {
    return end == End::end_of_input || end == End::stopped ? 0 : 1;
  }
};

}  // namespace odas
