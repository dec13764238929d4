// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "odas/studio/session_reader.hpp"

namespace odas {

/// The sessions of a folder: files of MCAP that a Studio made. Other files are not seen, and not touched.
///
/// One thread at a time. Throws RpcError: `not_found`, `failed`.
class SessionShelf {
 public:
  explicit SessionShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// As `sessions.list` of docs/protocol.md. `unfinished`: one that is being recorded is left out.
  [[nodiscard]] nlohmann::json list(const std::string& unfinished);
  void rename(const std::string& name, const std::string& label);
  void remove(const std::string& name);
  /// None: it is none of ours.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name) const;

 private:
  struct Known {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;
    SessionInfo info;
  };
  const SessionInfo& read(const std::filesystem::path& file);
  std::filesystem::path must_find(const std::string& name) const;

  std::filesystem::path folder_;
  std::map<std::string, Known> known_;
};

}  // namespace odas
