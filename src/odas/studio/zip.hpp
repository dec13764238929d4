// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace odas {

/// A ZIP archive of files as they are, without compression: sound does not shrink. Long sizes (zip64) where
/// they are needed.
/// Source: PKWARE, "APPNOTE.TXT, .ZIP file format specification", 6.3.
class ZipWriter {
 public:
  /// Replaces the file. `always_long`: long sizes even where short ones would do. Throws IoError.
  explicit ZipWriter(std::filesystem::path file, bool always_long = false);

  /// Adds a file, as long as it is now, under a plain name of UTF-8. Throws IoError.
  void add(const std::filesystem::path& file, const std::string& name);
  /// Throws IoError.
  void close();

 private:
  struct Entry {
    std::string name;
    std::uint64_t size = 0, at = 0;
    std::uint32_t sum = 0, time = 0;
  };
  [[nodiscard]] std::vector<char> local_header(const Entry& entry) const;
  [[nodiscard]] std::vector<char> directory(std::uint64_t at) const;
  [[nodiscard]] bool is_long(std::uint64_t number) const noexcept {
    return always_long_ || number >= 0xFFFFFFFF;
  }
  void put(const std::vector<char>& bytes);

  std::filesystem::path path_;
  std::ofstream file_;
  std::vector<Entry> entries_;
  bool always_long_;
};

}  // namespace odas
