// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace odas {

/// `[=========>          ]  47 %  0:12 left`
[[nodiscard]] std::string progress_line(double share, double seconds_left);

/// A line on stderr that grows, with the time left. Silent where stderr is not a terminal.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share`: 0..1 of the work is done. Cheap: draws at most ten times a second.
  void show(double share);
  /// Wipes the line, so that something else can be said.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool on_terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace odas
