// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace odas {

/// Taps of the filter that an estimate may differ by from its reference: another microphone, a beam.
inline constexpr std::size_t kProjectionTaps = 512;

/// What of `estimate` is `target` through a short filter, over the rest, dB: signal to distortion ratio.
///
/// Method: least squares for the taps (-256 .. 255 samples), 10 log10(|y|^2 / |estimate - y|^2).
/// Source: Vincent, Gribonval and Fevotte, IEEE TASLP 14(4), 2006 (BSS Eval). Shapes: both of one length.
[[nodiscard]] double sdr_db(std::span<const float> estimate, std::span<const float> target);

/// The same with one factor in place of the filter: scale-invariant SDR, dB.
/// Source: Le Roux et al., "SDR - half-baked or well done?", ICASSP 2019.
[[nodiscard]] double si_sdr_db(std::span<const float> estimate, std::span<const float> target);

/// What of `estimate` is `target`, over what more of it the other talkers explain, each through a filter of
/// its own, dB: signal to interference ratio. Noise and distortion do not count. Others that are silent are
/// left out; with none there is nothing to interfere, and the ratio is infinite.
///
/// Source: as sdr_db. Cost: cubic in (1 + others) * kProjectionTaps.
[[nodiscard]] double sir_db(std::span<const float> estimate, std::span<const float> target,
                            std::span<const std::vector<float>> others);

/// Solves T x = y for the symmetric Toeplitz matrix T[i][j] = first_row[|i - j|]: Levinson's recursion.
[[nodiscard]] std::vector<double> solve_toeplitz(std::span<const double> first_row,
                                                 std::span<const double> y);

}  // namespace odas
