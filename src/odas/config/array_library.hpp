// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace odas {

/// A configuration that is known by its name: that of its file, without ".cfg".
struct ArrayFile {
  std::string name;
  std::filesystem::path path;
  std::string title;  // what it is for: its first comment, up to the colon; may be empty
};

/// Where the Studio saves a user's own: $XDG_CONFIG_HOME/odas, or ~/.config/odas. Empty: there is no home.
[[nodiscard]] std::filesystem::path user_array_folder();

/// The folders where configurations are found by name, earlier ones first: ./configs, the user's, /etc/odas
/// (the machine's), then those that come with the program: ../share/odas/configs beside its folder where it
/// is installed,
/// ../../configs in a build tree.
[[nodiscard]] std::vector<std::filesystem::path> array_folders();

/// All of these folders, sorted by name. Of files of the same name the first folder's counts.
[[nodiscard]] std::vector<ArrayFile> array_files(const std::vector<std::filesystem::path>& folders);

/// The file that a user means by `name`: a path, or the name of an array in one of the folders. Throws
/// ConfigError with the names that there are, the nearest one first.
[[nodiscard]] std::filesystem::path find_configuration(const std::string& name,
                                                       const std::vector<std::filesystem::path>& folders);
[[nodiscard]] std::filesystem::path find_configuration(const std::string& name);

}  // namespace odas
