// SPDX-License-Identifier: MIT
#include "odas/studio/log_book.hpp"

#include <chrono>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "odas/studio/wire.hpp"

namespace odas {

void LogBook::say(const std::string& level, const std::string& text) {
  if (!program_.empty()) {
    const std::string kind = level == "info" ? "" : level + ": ";
    // One call: lines of several threads stay whole.
    std::fprintf(stderr, "%s: %s%s\n", program_.c_str(), kind.c_str(), text.c_str());
  }
  to_.announce(
      "log",
      {{"type", "log"},
       {"lines", {{{"at", iso_time(std::chrono::system_clock::now())}, {"level", level}, {"text", text}}}}});
}

}  // namespace odas
