// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "odas/scene/separation_score.hpp"

namespace odas {

/// A talker as he would be if it were known of each time and frequency how much of microphone 1 is he: what a
/// single-channel filter can give at best.
///
/// Method: |S|^2 / (|S|^2 + |X - S|^2) on the first microphone's frames of 512 samples, hop 128 (ideal ratio
/// mask; Wang and Chen, IEEE/ACM Trans. ASLP 26(10), 2018, eq. 4).
/// Symbols: X: the first microphone; S: the talker's image there.
[[nodiscard]] std::vector<float> ideal_mask_voice(const std::vector<float>& mic,
                                                  const std::vector<float>& image);

/// The mean SDR of these voices over the talkers, dB, each over the whole scene. Empty: nobody talks.
[[nodiscard]] std::optional<double> ideal_mask_sdr_db(const KnownSound& sound);

}  // namespace odas
