// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace odas {

/// Cross-correlation at `count` lags from `first` on: c[i] = sum over n of a[n + first + i] b[n], samples
/// beyond the ends being zero.
///
/// Method: by FFT, a block of `b` after the other, the blocks summed in double precision, so that a long
/// recording is as exact as a short one. Shapes: `a` and `b` of any length, result [count].
[[nodiscard]] std::vector<double> correlate(std::span<const float> a, std::span<const float> b, long first,
                                            std::size_t count);

/// The lag in 0 .. count-1 at which the two are most alike, whatever the sign.
[[nodiscard]] std::size_t best_lag(std::span<const float> a, std::span<const float> b, std::size_t count);

/// y[n] = sum over k of taps[k] x[n + advance - k], of the length of `x`.
[[nodiscard]] std::vector<float> filter(std::span<const float> x, std::span<const double> taps,
                                        std::size_t advance);

}  // namespace odas
