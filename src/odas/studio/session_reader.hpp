// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "odas/studio/mcap_reader.hpp"

namespace odas {

/// What a list of sessions shows of one.
struct SessionInfo {
  double seconds = 0;
  std::uint64_t start_ns = 0;  // UTC, of the first hop
  std::vector<std::string> audio;
  std::string fault;  // "": it is whole; "was cut off after 12.3 s"
  bool ours = false;  // a Studio made it
};

/// Reads the sessions that SessionRecorder writes. Of a file that was cut off or damaged, what stands before
/// that.
class SessionReader {
 public:
  /// Throws IoError: no such file, no MCAP.
  explicit SessionReader(std::filesystem::path file) : file_(std::move(file)) { McapReader check(file_); }

  /// Quick for a whole file; one that was cut off is read through.
  [[nodiscard]] SessionInfo info() const;

  struct Visitor {
    std::function<void(const nlohmann::json& run)> run{};
    std::function<void(const nlohmann::json& hop, std::uint64_t time_ns)> hop{};
    std::function<void(const std::string& stream, std::span<const char> packet)> audio{};
    std::function<void(const std::string& topic, const nlohmann::json& message)> text{};
  };
  /// Tells of each message in order. "", or the fault, as of SessionInfo.
  std::string read(const Visitor& visitor) const;

 private:
  std::filesystem::path file_;
};

}  // namespace odas
