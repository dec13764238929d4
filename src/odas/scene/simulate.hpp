// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "odas/scene/scene.hpp"

namespace odas {

/// Of which microphones the images of the targets are kept.
enum class Images { of_the_first, of_all };

/// Plays a scene. The same scene gives the same sound, whatever the platform (up to the rounding of its FFT).
///
/// Method: each source through the responses of the room (room.hpp). A source that moves is cut into pieces
/// under overlapping triangles that sum to 1; each piece goes through the responses of the place that the
/// source has in its middle, so that all is continuous. The paths of up to two walls are renewed every 8 ms,
/// the rest, which is diffuse, every 128 ms. Then the noise is added.
/// Errors: none for a scene that scene_file.hpp has let through; broken preconditions are contracts.
/// `progress`: called now and then with the share that is done.
[[nodiscard]] SimulatedScene simulate(const Scene& scene, const std::function<void(double)>& progress = {},
                                      Images images = Images::of_the_first);

}  // namespace odas
