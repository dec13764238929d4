// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace odas {

/// The outline of a sound file.
struct Waveform {
  double seconds = 0;
  float peak = 0;            // largest magnitude, full scale 1
  std::vector<float> peaks;  // largest magnitude of each of equal stretches
};

/// Reads a mono file in `columns` stretches (fewer where it is shorter than that). Throws IoError.
[[nodiscard]] Waveform waveform_of(const std::filesystem::path& file, std::size_t columns);

/// Writes the bytes of a file as base64 (RFC 4648). Throws IoError.
void write_base64(std::ostream& out, const std::filesystem::path& file);

}  // namespace odas
