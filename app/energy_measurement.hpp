// SPDX-License-Identifier: MIT
// The energies E of the potentials of a sound, by the real pipeline.
#pragma once

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/run.hpp"
#include "odas/tracking/mixture_fit.hpp"

namespace odas {

struct Energies : Heard {
  double seconds = 0;  // of sound that counted
};

/// Runs `seconds` of a source (all of it, where 0) through the localization of `pipeline`, which goes on from
/// what it heard before. The first second counts for nothing: the estimate of the noise settles. Throws
/// IoError where the source fails.
[[nodiscard]] Energies measure_energies(AudioSource& source, const Configuration& config, Pipeline& pipeline,
                                        double seconds, const RunOptions& options);

}  // namespace odas
