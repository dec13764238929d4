// SPDX-License-Identifier: MIT
// What ODAS printed for scenes with known truth; outside the repository, and absent for most.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odas::test {

/// The folder of shared test material, if this machine has it: $ODAS_SHARED, or beside the source tree.
[[nodiscard]] std::optional<std::filesystem::path> shared_folder();

/// One row of ODAS's JSON: of potentials x, y, z, E; of tracks id, x, y, z and the activity.
struct GoldenRow {
  std::uint64_t id = 0;
  float x = 0, y = 0, z = 0, value = 0;
};
struct GoldenHop {
  std::uint64_t time = 0;
  std::vector<GoldenRow> rows;
};

/// Reads a gzipped stream of ODAS's JSON objects.
[[nodiscard]] std::vector<GoldenHop> read_goldens(const std::filesystem::path& file);

/// A number as ODAS prints it, in thousandths: "%1.3f".
[[nodiscard]] long thousandths(float value);

}  // namespace odas::test
