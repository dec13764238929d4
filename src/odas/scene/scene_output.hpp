// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "odas/scene/scene.hpp"

namespace odas {

enum class RecordingFormat { wav, flac };

/// Writes what a scene came to into `folder`, which is made where it is absent: `mics.wav` (or `mics.flac`,
/// up to 8 microphones), `image_K.wav`, `truth.json`; 16 bit. Throws IoError.
void write_scene(const Scene& scene, const SimulatedScene& result, RecordingFormat format,
                 const std::filesystem::path& folder);

}  // namespace odas
