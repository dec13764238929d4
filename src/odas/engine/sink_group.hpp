// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <span>
#include <string>
#include <vector>

#include "odas/engine/run.hpp"
#include "odas/engine/sink.hpp"

namespace odas {

/// All sinks of a run: writes to those that are well, flushes them in time, closes each of them whatever has
/// happened, and keeps the first failure. Used by one thread; `failed` may be asked by others.
class SinkGroup {
 public:
  explicit SinkGroup(std::span<Sink* const> sinks);

  [[nodiscard]] std::size_t size() const noexcept { return members_.size(); }

  void write(std::size_t sink, const HopResult& hop);
  void write_all(const HopResult& hop);
  /// Flushes all if the last time was a second ago.
  void flush_in_time();
  void close();

  [[nodiscard]] bool failed() const noexcept { return failed_.load(std::memory_order_relaxed); }

  /// Puts failure, clipped samples and warnings into the summary. After `close`.
  void report(RunSummary& summary, const std::function<void(std::string)>& warn) const;

 private:
  struct Member {
    Sink* sink;
    bool well = true;
  };
  void note(Member& member, const IoStatus& status);

  std::vector<Member> members_;
  std::atomic<bool> failed_{false};
  std::string fault_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace odas
