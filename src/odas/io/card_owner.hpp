// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace odas {

/// Which program captures from a sound card: "arecord (process 1234)"; "" where it cannot be told. `pcm`:
/// hw:1,0 or hw:CARD=Array,DEV=0, also behind plughw. `proc`: /proc.
[[nodiscard]] std::string owner_of_card(const std::string& pcm, const std::filesystem::path& proc = "/proc");

}  // namespace odas
