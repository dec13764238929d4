// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/run.hpp"
#include "odas/engine/sink.hpp"

namespace odas {

/// Reads `source` to its end, hop by hop: mapping, resampling, `pipeline`, `sinks`; all in the caller's
/// thread. Bit-equal to the same run with threads. Closes all sinks, also after a failure. `config` must be
/// the one that `pipeline` was made from. Throws ConfigError where the source does not fit it.
RunSummary run_offline(AudioSource& source, const Configuration& config, Pipeline& pipeline,
                       std::span<Sink* const> sinks, const RunOptions& options);

}  // namespace odas
