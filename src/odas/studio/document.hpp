// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "odas/config/reader.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// A configuration in the hands of the Studio.
struct Document {
  std::string text;            // with what it includes in its place
  std::string name;            // of the array, or of the file without its ending
  std::filesystem::path file;  // where it came from, and is saved to; "": nowhere yet

  /// What the reader is told to call it in messages, and beside which it looks for what is included.
  [[nodiscard]] std::string source_name() const;
};

/// The configuration that a user means by a path or the name of an array. Throws ConfigError where there is
/// none; what is wrong in it shows only when it is checked.
[[nodiscard]] Document read_document(const std::string& file_or_array);

/// 16 hexadecimal digits that tell texts apart (FNV-1a, 64 bits); not against those who mean ill.
[[nodiscard]] std::string hash_of(std::string_view text);

/// Which of its own outputs a configuration has in the Studio.
enum class Outputs {
  all,      // as `odas live`
  network,  // files and the terminal are left out: the page shows and records
};

/// A document that can be run: read, found good, and with its pipeline.
struct CheckedDocument {
  Document document;
  LoadedConfiguration loaded;  // its faults are warnings
  Configuration config;        // as it runs: everything is wanted, files have their real pace
  std::unique_ptr<Pipeline> pipeline;
};

/// Throws ConfigError with all that is wrong.
[[nodiscard]] CheckedDocument check_document(Document document, Outputs outputs);

/// Writes the text so that a reader sees the old one or the new one. Throws IoError.
void save_text(const std::filesystem::path& file, std::string_view text);

}  // namespace odas
