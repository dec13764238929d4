// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace odas {

/// Becomes true at the first Ctrl-C (SIGINT), SIGTERM, or SIGHUP (its terminal is closed; not under nohup):
/// the run ends well, with its files finished. A second one ends the program at once, as if nobody had
/// listened.
[[nodiscard]] const std::atomic<bool>& stop_on_signals();

}  // namespace odas
