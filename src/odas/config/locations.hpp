// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "odas/base/error.hpp"
#include "odas/config/source_text.hpp"

namespace odas {

/// Which line of which file each setting stands on, so that a fault found later (by a stage that knows only
/// the path) can still name the line.
class Locations {
 public:
  /// The file itself: what a fault gets whose path is nowhere.
  void set_file(std::string file) { file_ = std::move(file); }
  void add(std::string path, Location location) {
    lines_.insert_or_assign(std::move(path), std::move(location));
  }

  /// Whether the user wrote it.
  [[nodiscard]] bool has(std::string_view path) const { return lines_.find(path) != lines_.end(); }

  /// Of "general.mics[2].mu", or else of what it stands in: "general.mics[2]", "general.mics", "general".
  [[nodiscard]] Location find(std::string_view path) const;

  /// The fault with file and line, where it has none.
  [[nodiscard]] Fault locate(Fault fault) const;
  /// The same for all faults of an error.
  [[nodiscard]] ConfigError locate(const ConfigError& error) const;

 private:
  std::string file_;
  std::map<std::string, Location, std::less<>> lines_;
};

}  // namespace odas
