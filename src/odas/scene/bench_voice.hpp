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

}  // namespace odas
