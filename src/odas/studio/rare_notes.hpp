// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace odas {

/// So that a flood of refusals is one line: each kind once a minute.
class RareNotes {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::minutes kPause{1};

  [[nodiscard]] bool is_due(const std::string& kind, Clock::time_point now) {
    const auto [said, is_new] = said_.try_emplace(kind, now);
    if (is_new) return true;
    if (now - said->second < kPause) return false;
    said->second = now;
    return true;
  }

 private:
  std::map<std::string, Clock::time_point> said_;
};

}  // namespace odas
