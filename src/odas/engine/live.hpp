// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/run.hpp"
#include "odas/engine/sink.hpp"

namespace odas {

/// The run with three threads: the caller's reads `source`, one runs `pipeline`, one writes to `sinks`.
///
/// A recording waits for the sinks, so that nothing is lost. A live source waits for nobody: a hop that a
/// full queue has no room for is dropped and counted. Two threads are started, with all signals blocked:
/// signals reach the caller. The result is bit-equal to that of run_offline. Throws ConfigError as it does.
RunSummary run_live(AudioSource& source, const Configuration& config, Pipeline& pipeline,
                    std::span<Sink* const> sinks, const RunOptions& options);

}  // namespace odas
