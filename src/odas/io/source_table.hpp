// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// Those who are there, a line each, with a head: for the eyes. Tags show nothing that a terminal would obey.
[[nodiscard]] std::vector<std::string> source_table(std::span<const Track> tracks);

/// `id 7, azimuth 90.0, elevation 0.0, activity 0.50, speech, "door"`: for logs and scripts.
[[nodiscard]] std::string source_line(const Track& track);

/// What a terminal can show without obeying it: control characters become `?`, and what is no ASCII stays if
/// `text` is UTF-8.
[[nodiscard]] std::string harmless(std::string_view text);

}  // namespace odas
