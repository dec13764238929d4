// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "odas/base/grid.hpp"
#include "odas/scene/scene.hpp"

namespace odas {

/// Words, and when they begin, in seconds.
struct Utterance {
  double start = 0;
  std::string text;
};

/// What a source sounds like, before the room.
struct SoundRecipe {
  enum class Kind { file, speech, noise };
  Kind kind = Kind::noise;
  std::filesystem::path file;         // file: its first channel is taken
  std::vector<Utterance> utterances;  // speech, by espeak-ng
  std::string voice = "en-us";
  int words_per_minute = 160;
  int pitch = 50;  // 0..99
  NoiseColour colour = NoiseColour::white;
  double start = 0;   // s of silence before it
  float gain_db = 0;  // over -30 dB of full scale at a distance of 1 m, RMS while it is active
};

/// The sound at `sample_rate`, at the most `samples` long. Throws IoError: no such file, no espeak-ng. A
/// voice that espeak-ng does not know is no error: it speaks with its own, and does not say so.
[[nodiscard]] std::vector<float> make_sound(const SoundRecipe& recipe, int sample_rate, std::size_t samples,
                                            std::uint32_t seed);

/// The first channel of a sound file, resampled. Throws IoError.
[[nodiscard]] std::vector<float> read_mono(const std::filesystem::path& file, int sample_rate);

/// All channels of a sound file, as they are: [channel][sample]. Throws IoError.
[[nodiscard]] Grid<float> read_channels(const std::filesystem::path& file);

}  // namespace odas
