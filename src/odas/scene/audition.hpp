// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "odas/scene/separation_score.hpp"
#include "odas/scene/truth.hpp"

namespace odas {

/// What a system said of a recording.
struct Audition {
  std::vector<HeardHop> tracks;
  std::optional<std::vector<HeardPotential>> potentials;  // empty: none were written
  VoiceOf separated, postfiltered;                        // empty: none were written
};

/// Reads the output of a system from a folder, in ODAS's formats or in ours:
///   tracks.json or tracks.jsonl           needed
///   pots.json or potentials.jsonl
///   separated.raw or voices/source_ID.wav
///   postfiltered.raw
/// A file of JSON that was cut counts as far as it goes. Raw sound is 16 bit at the scene's rate, a channel a
/// slot. Throws IoError.
[[nodiscard]] Audition read_audition(const std::filesystem::path& folder, const KnownScene& scene);

}  // namespace odas
