// SPDX-License-Identifier: MIT
#pragma once

#include "odas/engine/config.hpp"
#include "odas/scene/audition.hpp"
#include "odas/scene/scene.hpp"

namespace odas {

/// A scene as one listens to it and scores it.
struct PlayedScene {
  KnownScene truth;
  KnownSound sound;  // what microphone 1 heard, and of whom
  Grid<float> mics;  // [mic][sample]
};

/// The truth of a simulated scene as a score wants it. All is rounded as write_scene does it: whether a scene
/// comes from files or not changes nothing.
[[nodiscard]] PlayedScene played(const Scene& scene, SimulatedScene simulated);

/// What odas hears of it, in this thread: what `odas run` would write into files, and `odas score` read. The
/// configuration says nothing of the channels: channel m is microphone m, at the processing rate. Its
/// `pipeline.wanted` says what is computed. Throws ConfigError.
[[nodiscard]] Audition listen(const PlayedScene& scene, Configuration config);

}  // namespace odas
