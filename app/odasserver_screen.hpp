// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// Shows on stdout who is there: on a terminal as a table that is drawn in place; else as a line when
/// somebody comes, once a second while he is there, and when he goes.
class ServerScreen {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ServerScreen(bool quiet);
  ~ServerScreen() { clear(); }
  ServerScreen(const ServerScreen&) = delete;
  ServerScreen& operator=(const ServerScreen&) = delete;

  /// The tracks of each hop: the lines show also who is there for an instant only.
  void hear(std::span<const Track> tracks);
  /// From time to time: those who are there now. Cheap: draws at most ten times a second.
  void show(std::span<const Track> tracks, const std::vector<std::string>& state, Clock::time_point now);
  /// A message, on stderr; the table is drawn anew below it.
  void say(const std::string& message);

 private:
  void clear();
  void draw(const std::vector<std::string>& lines);
  void print_lines(std::span<const Track> tracks, Clock::time_point now);

  bool quiet_;
  bool on_terminal_;
  std::size_t drawn_ = 0;  // lines on the screen
  Clock::time_point last_{};
  Clock::time_point begin_ = Clock::now();
  std::map<std::uint64_t, Clock::time_point> printed_;  // by id: when last
};

}  // namespace odas
