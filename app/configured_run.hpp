// SPDX-License-Identifier: MIT
// A configuration run as it stands: what `odas live` and `odaslive` share.
#pragma once

#include <atomic>
#include <string>

#include "odas/engine/run.hpp"

namespace odas {

struct ConfiguredRun {
  bool threads = true;
  bool like_odas = false;  // its silent first block, and no last one that is not full
};

/// Runs FILE until its input ends or `stop` is set. Warnings go to stderr at once, each with `program` before
/// it. Throws ConfigError with all faults, IoError where a source or sink cannot be opened.
[[nodiscard]] RunSummary run_configuration(const std::string& file, const ConfiguredRun& how,
                                           const std::string& program, const std::atomic<bool>& stop);

/// Says on stderr why a run has failed, if it has. The exit code.
int say_end(const RunSummary& summary, const std::string& program);

/// Hops, their time, and what was lost, in a line or two.
[[nodiscard]] std::string describe(const Metrics& metrics);

}  // namespace odas
