// SPDX-License-Identifier: MIT
#pragma once

#include "odas/scene/random.hpp"
#include "odas/scene/sound.hpp"

namespace odas {

/// Who talks, how fast and how high, and a sentence or two; drawn by `random`. The two halves of a benchmark
/// share neither voices nor sentences.
[[nodiscard]] SoundRecipe draw_voice(Random& random, bool test_half);

/// `count` sentences, none twice in a row.
[[nodiscard]] std::string draw_words(Random& random, bool test_half, int count);

/// The voices that a crowd is made of (DiffuseNoise::voices), at the rate of the scene. Throws IoError.
[[nodiscard]] std::vector<std::vector<float>> crowd_voices(std::uint32_t seed, bool test_half,
                                                           int sample_rate, double seconds);

}  // namespace odas
