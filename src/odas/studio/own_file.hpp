// SPDX-License-Identifier: MIT
// Files of the folder of recordings: which names may be asked for, and how they are written.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "odas/engine/io_status.hpp"

namespace odas {

/// Whether it can only be a file within its folder: no path, nothing hidden, nothing that leads out of it.
[[nodiscard]] bool is_plain_name(std::string_view name) noexcept;

/// Whether it is a file and no link to one.
[[nodiscard]] bool is_file(const std::filesystem::path& path) noexcept;

/// Writes a small file so that a reader sees the old one or the new one, whatever happens in between.
IoStatus write_whole(const std::filesystem::path& file, std::string_view content);

/// `folder`/NAME.EXTENSION, or NAME_2 and so on: one of which neither it nor its JSON exists.
[[nodiscard]] std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& name,
                                              const std::string& extension);

/// `studio.recordings`, or where the user's data lie: $XDG_DATA_HOME/odas/recordings.
[[nodiscard]] std::filesystem::path recordings_folder(const std::string& configured);

}  // namespace odas
