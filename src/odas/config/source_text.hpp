// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "odas/base/error.hpp"

namespace odas {

/// Where something stands in a configuration.
struct Location {
  std::string file;
  int line = 0;  // from 1; 0: unknown
};

/// The text of a configuration, made ready for libconfig, which has habits of its own:
/// - an `@include` of a folder ends the program: the files are put in here, looked for beside the including
///   file first, in the working directory then, and last where arrays are found by name (array_library.hpp);
/// - the numbers of an array `[]` must be all whole or all not: arrays are written as lists `()`;
/// - whole numbers beyond 32 bits are cut without a word: they are written as floats.
/// Lines keep their number. Faults found on the way (files that cannot be read, brackets that do not match)
/// are appended to `faults`.
class SourceText {
 public:
  static SourceText from_file(const std::filesystem::path& path, std::vector<Fault>& faults);
  /// `name` stands for the file in messages.
  static SourceText from_text(std::string_view text, const std::string& name, std::vector<Fault>& faults);

  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Of a line of text(), from 1.
  [[nodiscard]] Location location(int line) const;
  /// All lines as they were written, with what they include in its place.
  [[nodiscard]] std::string written() const;
  /// The line as the user wrote it, without the space around it.
  [[nodiscard]] std::string excerpt(int line) const;

 private:
  friend class SourceScanner;
  struct Line {
    Location location;
    std::string written;
  };
  std::string name_;
  std::string text_;
  std::vector<Line> lines_;
};

}  // namespace odas
