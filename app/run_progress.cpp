// SPDX-License-Identifier: MIT
#include "run_progress.hpp"

#include <cstdio>
#include <optional>

#include "stop.hpp"

namespace odas {

void say(const std::string& text) { std::fprintf(stderr, "odas: %s\n", text.c_str()); }

RunOptions shown_by(Progress& progress) {
  RunOptions options;
  options.stop = &stop_on_signals();
  options.progress = [&](std::uint64_t done, std::optional<std::uint64_t> total) {
    if (total) progress.show(static_cast<double>(done) / static_cast<double>(*total));
  };
  options.warn = [&](const std::string& warning) {
    progress.clear();
    say("warning: " + warning);
  };
  return options;
}

}  // namespace odas
