// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "odas/scene/scene.hpp"

namespace odas {

/// Reads a scene (docs/scenes.md), and all that it names: the array's configuration, sounds, spoken words.
/// Files named in it are looked for beside it. Throws ConfigError with all faults and their JSON paths;
/// IoError where a file is missing or espeak-ng is not there.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file);

/// The same from a text; `name` stands for the file in messages.
[[nodiscard]] Scene read_scene_text(std::string_view text, const std::filesystem::path& folder,
                                    const std::string& name);

}  // namespace odas
