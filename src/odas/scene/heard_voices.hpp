// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "odas/scene/separation_score.hpp"

namespace odas {

/// What is known of a raw file from the tracks beside it.
struct RawLayout {
  std::size_t hop_size = 128;  // samples
  std::size_t slots = 0;       // that were seen in the tracks: there may be more channels
  std::size_t hops = 0;
};

/// Interleaved 16 bit samples, one channel a slot. The number of channels follows from the size of the file:
/// lines of JSON leave empty slots out. Empty for an empty file. Throws IoError.
[[nodiscard]] VoiceOf raw_voices(const std::filesystem::path& file, const RawLayout& layout);

/// A folder with index.json and a file for each source: `odas run`'s. Empty where nobody was followed.
/// Throws IoError.
[[nodiscard]] VoiceOf voices_by_id(const std::filesystem::path& folder, const KnownScene& scene);

}  // namespace odas
