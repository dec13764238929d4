// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "odas/dsp/noise_dictionary.hpp"
#include "odas/pipeline/config.hpp"

namespace odas {

/// A noise dictionary in a file: lines of text, "data", and numbers (docs/noise.md has the format).
/// Throws IoError.
void write_noise_file(const NoiseDictionary& dictionary, const std::filesystem::path& file);

/// Throws IoError where there is no such file, where it is no dictionary, or one cut short, or one whose
/// numbers are no covariances.
[[nodiscard]] NoiseDictionary read_noise_file(const std::filesystem::path& file);

/// What of a configuration makes a dictionary useless: another rate, hop, frame or array. Empty: it fits.
[[nodiscard]] std::string misfit_of(const NoiseDictionary& dictionary, const PipelineConfig& config);

}  // namespace odas
