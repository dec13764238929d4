// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "progress.hpp"

#include "odas/engine/run.hpp"

namespace odas {

/// A line on stderr, for the user.
void say(const std::string& text);

/// A run that Ctrl-C stops, whose way through a recording `progress` shows, and whose warnings are said in
/// its place. `progress` outlives the run.
[[nodiscard]] RunOptions shown_by(Progress& progress);

}  // namespace odas
