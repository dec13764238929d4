// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace odas {

/// The recordings of a folder: those that a Studio made, known by the JSON beside them. Other files are not
/// seen, and not touched.
///
/// One thread at a time. Throws RpcError: `not_found`, `failed`.
class RecordingShelf {
 public:
  explicit RecordingShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// As `recordings.list` of docs/protocol.md.
  [[nodiscard]] nlohmann::json list();
  /// As `recordings.peaks`: the envelope over all channels. Kept for the next who asks.
  [[nodiscard]] nlohmann::json peaks(const std::string& name, std::size_t columns);
  void rename(const std::string& name, const std::string& label);
  void remove(const std::string& name);
  /// Its WAV, or the JSON of that name. None: it is none of ours.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name);

 private:
  struct Known {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;
    nlohmann::json content;  // null: none of ours
  };
  /// What the JSON says, from memory where it has not changed; null: none of ours.
  const nlohmann::json& read(const std::filesystem::path& json_file);
  std::filesystem::path must_find(const std::string& name);

  std::filesystem::path folder_;
  std::map<std::string, Known> known_;
  std::deque<std::pair<std::string, nlohmann::json>> peaks_;  // by name, size and columns
};

}  // namespace odas
