// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace odas {

/// Where a sound without noise is active, [sample / step].
///
/// Method: energy of 20 ms around, over a threshold 30 dB under the loudest 5 % of what sounds at all; pauses
/// under 0.2 s, as between words, do not end it. A sound that is silent throughout is never active.
[[nodiscard]] std::vector<std::uint8_t> activity_of(std::span<const float> sound, std::size_t step,
                                                    int sample_rate);

}  // namespace odas
