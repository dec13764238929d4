// SPDX-License-Identifier: MIT
#include "odas/studio/own_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace odas {

namespace fs = std::filesystem;

bool is_plain_name(std::string_view name) noexcept {
  constexpr std::size_t kLongest = 255;
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         name.find("..") == std::string_view::npos && std::none_of(name.begin(), name.end(), [](char c) {
           return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
         });
}

bool is_file(const fs::path& path) noexcept {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() == fs::file_type::regular;
}

IoStatus write_whole(const fs::path& file, std::string_view content) {
  const fs::path part = file.parent_path() / ("." + file.filename().string() + ".part");
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  std::error_code error;
  if (out) fs::rename(part, file, error);
  if (out && !error) return {};
  std::error_code ignored;
  fs::remove(part, ignored);
  return IoStatus::failed("cannot write " + file.string() + ": " +
                          (error ? error.message() : "is the disk full, or the folder not ours?"));
}

fs::path free_name(const fs::path& folder, const std::string& name, const std::string& extension) {
  const auto taken = [](const fs::path& file) {
    std::error_code ignored;
    return fs::symlink_status(file, ignored).type() != fs::file_type::not_found;
  };
  for (int n = 1;; ++n) {
    const std::string stem = n == 1 ? name : name + "_" + std::to_string(n);
    if (!taken(folder / (stem + extension)) && !taken(folder / (stem + ".json"))) {
      return folder / (stem + extension);
    }
  }
}

fs::path recordings_folder(const std::string& configured) {
  const auto text = [](const char* name) {
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it
    return std::string(value != nullptr ? value : "");
  };
  const std::string home = text("HOME");
  if (configured.starts_with("~/")) return fs::path(home) / configured.substr(2);
  if (!configured.empty()) return configured;
  const std::string data = text("XDG_DATA_HOME");
  return (data.empty() ? fs::path(home) / ".local" / "share" : fs::path(data)) / "odas" / "recordings";
}

}  // namespace odas
