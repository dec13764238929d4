// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "odas/base/error.hpp"
#include "odas/config/locations.hpp"
#include "odas/engine/config.hpp"

namespace odas {

/// What a configuration file says, and all that is wrong with it.
struct LoadedConfiguration {
  Configuration config;
  std::vector<Fault> faults;  // errors and warnings, each with its line, in the order of the file
  Locations locations;        // for the faults that later stages find

  /// No errors; there may be warnings.
  [[nodiscard]] bool ok() const;
};

/// Reads a configuration in ODAS's grammar (libconfig), checks it, and collects every fault at once.
/// Throws nothing that the content of the file could bring about. An absent key means ODAS's behaviour.
/// `config.pipeline.wanted` is what the outputs of the file ask for.
[[nodiscard]] LoadedConfiguration read_configuration(const std::filesystem::path& file);

/// The same from a text; `name` stands for the file in messages.
[[nodiscard]] LoadedConfiguration read_configuration_text(std::string_view text, const std::string& name);

/// The same for those who cannot go on with errors. Throws ConfigError with all faults; else the faults that
/// are left are warnings.
[[nodiscard]] LoadedConfiguration load_configuration(const std::filesystem::path& file);

}  // namespace odas
