// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace odas {

/// What a request for something that is no part of the page gets: a file of the disk, or bytes.
struct Served {
  std::filesystem::path file;  // "": `body` it is
  bool remove_file = false;    // it was made for this request alone
  std::string body;
  std::string type;           // "audio/wav"
  std::string download_name;  // not "": the browser saves it under this name
};

/// Knows recordings, sessions and exports by their path and query: `/api/v1/recordings/NAME`.
class FileProvider {
 public:
  using Query = std::multimap<std::string, std::string>;
  virtual ~FileProvider() = default;
  /// In the thread of the commands. None: there is no such thing. `path` is decoded, and may be anything.
  [[nodiscard]] virtual std::optional<Served> find(std::string_view path, const Query& query) = 0;
};

}  // namespace odas
