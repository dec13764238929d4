// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

namespace odas {

/// How intelligible `processed` is, against `clean`: about 0 (nothing is understood) to 1 (everything).
///
/// Method: both are resampled to 10 kHz; frames of 256 in which `clean` is more than 40 dB under its loudest
/// are left out; one-third octave bands from 150 Hz on, 15 of them; in each, stretches of 384 ms (30 frames)
/// of the amplitudes of both, the processed one scaled to the clean one's energy and clipped 15 dB over it,
/// are correlated; STOI is the mean over bands and stretches. Source: Taal, Hendriks, Heusdens and Jensen,
/// IEEE Trans. ASLP 19(7), 2011. Shapes: both of the same length, aligned in time. Errors: empty where less
/// than 30 frames of speech are left.
[[nodiscard]] std::optional<double> stoi(std::span<const float> clean, std::span<const float> processed,
                                         int sample_rate);

}  // namespace odas
