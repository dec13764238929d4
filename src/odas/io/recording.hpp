// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"

namespace odas {

/// Opens a recording: WAV, FLAC and whatever libsndfile knows by its header; anything else, and every .raw
/// and .pcm, is headerless PCM as `raw` describes it. Throws IoError: missing, not readable, empty, or not of
/// the rate and channels that `raw` says.
[[nodiscard]] std::unique_ptr<AudioSource> open_recording(const std::filesystem::path& file,
                                                          const RawConfig& raw);

}  // namespace odas
