// SPDX-License-Identifier: MIT
#include "odas/config/array_library.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string_view>

#include "odas/base/error.hpp"
#include "odas/config/nearest.hpp"
#include "odas/config/phrases.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".cfg";

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

std::string title_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  if (!line.starts_with('#')) return {};
  line.resize(std::min(line.find(": "), line.size()));
  line.erase(0, std::min(line.find_first_not_of("# "), line.size()));
  const std::size_t last = line.find_last_not_of(" \t\r:.,");
  line.resize(last == std::string::npos ? 0 : last + 1);
  return line;
}

/// How far what was written is from the beginning of a name: who knows the board but not our name for it
/// writes "respeaker".
std::size_t distance_to_beginning(std::string_view written, std::string_view name) {
  std::size_t least = edit_distance(written, name);
  for (std::size_t length = written.size() - 1; length <= written.size() + 1 && length < name.size();
       ++length) {
    least = std::min(least, edit_distance(written, name.substr(0, length)));
  }
  return least;
}

/// The name that holds the word, or begins nearly like it; empty where none does.
std::string meant(std::string_view written, const std::vector<ArrayFile>& files) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, written.size() / 4) + 1;
  for (const ArrayFile& file : files) {
    const bool holds = written.size() > 2 && file.name.find(written) != std::string::npos;
    const std::size_t distance = holds ? 0 : distance_to_beginning(written, file.name);
    if (distance < least) {
      least = distance;
      best = file.name;
    }
  }
  return best;
}

std::string nothing_of_this_name(const std::string& name, const std::vector<ArrayFile>& files) {
  std::string text = "there is no such file, and no array of this name";
  if (files.empty()) return text + " (nor any other: is odas installed?)";
  if (const std::string near = meant(name, files); !near.empty()) {
    text += "; did you mean " + in_quotes(near) + "?";
  }
  text += "\nThere are:";
  for (const ArrayFile& file : files) text.append(" ").append(file.name);
  return text;
}

}  // namespace

fs::path user_array_folder() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  // Relative ones are to be passed over, as the XDG base directory specification says.
  if (const fs::path folder = variable("XDG_CONFIG_HOME"); folder.is_absolute()) return folder / "odas";
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".config/odas";
  return {};
}

std::vector<fs::path> array_folders() {
  std::vector<fs::path> folders{"configs"};
  if (fs::path own = user_array_folder(); !own.empty()) folders.push_back(std::move(own));
  folders.emplace_back("/etc/odas");
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return folders;
  const fs::path bin = program.parent_path();
  folders.push_back(bin.parent_path() / "share/odas/configs");
  folders.push_back(bin.parent_path().parent_path() / "configs");
  return folders;
}

std::vector<ArrayFile> array_files(const std::vector<fs::path>& folders) {
  std::map<std::string, ArrayFile> found;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const fs::path& path = entry.path();
      if (path.extension() != kEnding || !is_there(path)) continue;
      const std::string name = path.stem().string();
      found.try_emplace(name, ArrayFile{name, path, title_of(path)});
    }
  }
  std::vector<ArrayFile> files;
  for (auto& [name, file] : found) files.push_back(std::move(file));
  return files;
}

fs::path find_configuration(const std::string& name, const std::vector<fs::path>& folders) {
  // What looks like a path is one: the reader says why it cannot be opened.
  if (is_there(name) || name.empty() || name.find('/') != std::string::npos || name.ends_with(kEnding)) {
    return name;
  }
  for (const fs::path& folder : folders) {
    if (fs::path path = folder / (name + std::string(kEnding)); is_there(path)) return path;
  }
  throw ConfigError(name, nothing_of_this_name(name, array_files(folders)));
}

fs::path find_configuration(const std::string& name) { return find_configuration(name, array_folders()); }

}  // namespace odas
