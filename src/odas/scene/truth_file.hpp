// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "odas/scene/separation_score.hpp"
#include "odas/scene/truth.hpp"

namespace odas {

/// What is true of a scene, as `odas simulate` writes it: a folder with truth.json, or that file alone.
/// Throws IoError: it is missing, or not of this form.
[[nodiscard]] KnownScene read_truth(const std::filesystem::path& folder_or_file);

/// mics.wav (or mics.flac) and image_K.wav beside truth.json. Empty where they are not there. Throws IoError
/// where one of them cannot be read, is missing among the others, or is not of the scene's sample rate.
[[nodiscard]] std::optional<KnownSound> read_known_sound(const std::filesystem::path& folder_or_file,
                                                         const KnownScene& scene);

}  // namespace odas
