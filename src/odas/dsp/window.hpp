// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace odas {

/// Square root of a symmetric Hann window, as ODAS takes: w[n] = sqrt((1 - cos(2 pi n / (N-1))) / 2).
/// Symmetric, both ends zero: with it potentials agree with ODAS's.
[[nodiscard]] std::vector<float> root_hann(std::size_t frame_size);

/// The synthesis window that makes analysis, overlap-add and synthesis a gain of exactly 1:
/// v[n] = w[n] / sum_m w[n + m hop]^2, the sum being taken for 1/2 at least: with a hop of more than 2/3 of
/// the frame, what lies between two frames fades instead of being restored from next to nothing. (Griffin and
/// Lim, 1984: the least-squares synthesis window.)
[[nodiscard]] std::vector<float> synthesis_window(const std::vector<float>& analysis, std::size_t hop_size);

}  // namespace odas
