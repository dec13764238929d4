// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "odas/base/grid.hpp"

namespace odas {

/// A talker as a linear beamformer would give him that knew all covariances: what several microphones can
/// give at best, on frames of 512 samples, without a filter behind.
///
/// Method, per bin: w = R_n^-1 R_s e / trace(R_n^-1 R_s), R_s: of the talker's images, R_n: of all else,
///   both the true ones, summed over the second before and the second after; a new w every quarter of a
///   second, so that talkers may walk. e: the first microphone.
/// Source: Souden, Benesty and Affes, "On optimal frequency-domain multichannel linear filtering for noise
///   reduction", IEEE TASLP 18(2), 2010, eq. 24 with beta = 0.
/// Shapes: mics and image [mic][sample]. Cost: bins x (frames mics^2 + quarters of a second x mics^3).
[[nodiscard]] std::vector<float> ideal_beamformer_voice(GridView<const float> mics,
                                                        GridView<const float> image);

/// The mean SDR of these voices over the talkers, dB, each over the whole scene. Empty: nobody talks.
[[nodiscard]] std::optional<double> ideal_beamformer_sdr_db(GridView<const float> mics,
                                                            std::span<const Grid<float>> images);

}  // namespace odas
