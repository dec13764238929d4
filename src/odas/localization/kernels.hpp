// SPDX-License-Identifier: MIT
// The three inner loops of SRP-PHAT, compiled for several instruction sets and chosen at run time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "odas/array/geometry.hpp"
#include "odas/base/grid.hpp"

namespace odas {

/// Rows of tables and buffers are padded to this many values: the widest vector that the kernels use.
inline constexpr std::size_t kKernelLanes = 8;
[[nodiscard]] constexpr std::size_t padded(std::size_t n) noexcept {
  return (n + kKernelLanes - 1) / kKernelLanes * kKernelLanes;
}

/// Cosines and sines that turn a cross-spectrum into the few lags that are ever read.
/// x[l] = sum_k w_k Re(C_k e^(j 2 pi k l / (r N))) / N, for |l| <= half_lags: the inverse DFT of C,
/// zero-padded r times, without the lags that nobody reads. w_k = 1 at k = 0 (and at k = N/2 where r = 1),
/// else 2.
class LagTable {
 public:
  LagTable(std::size_t frame_size, int interp_rate, std::size_t half_lags);

  [[nodiscard]] std::size_t bins() const noexcept { return cos_.rows(); }
  [[nodiscard]] std::size_t half_lags() const noexcept { return half_lags_; }
  [[nodiscard]] const Grid<float>& cos() const noexcept { return cos_; }
  [[nodiscard]] const Grid<float>& sin() const noexcept { return sin_; }
  [[nodiscard]] std::span<const std::uint16_t> all_bins() const noexcept { return all_bins_; }

 private:
  std::size_t half_lags_;
  Grid<float> cos_, sin_;  // [bin][lag 0..half_lags, padded]
  std::vector<std::uint16_t> all_bins_;
};

/// The cross-correlations of pairs of channels, of which `re` and `im` [mic][bin] are the weighted phasors.
/// `bins`, ascending, are those where they are not 0: the cost is in proportion to their number.
/// Row q of `out` holds lag l at column half_lags + l. `scratch` holds at least lag_scratch_size() values.
void lag_products(GridView<const float> re, GridView<const float> im, std::span<const Pair> pairs,
                  const LagTable& table, std::span<const std::uint16_t> bins, std::span<float> scratch,
                  GridView<float> out) noexcept;
[[nodiscard]] std::size_t lag_scratch_size(const LagTable& table) noexcept;

/// y[n] = max over |k| <= delta of x[n + k], for n in [first, last]. May write up to kKernelLanes - 1 values
/// beyond `last` in y and reads as far in x.
void sliding_max(const float* x, std::size_t first, std::size_t last, std::size_t delta, float* y) noexcept;

/// sums[c] = sum over q of rows[q][columns[q][c]], pairs in order. `columns.cols()` is padded.
void gather_sums(std::span<const float* const> rows, GridView<const std::uint16_t> columns,
                 std::span<float> sums) noexcept;

/// The instruction set in use: "AVX2", "SSE4", "NEON", ...
[[nodiscard]] const char* kernel_target() noexcept;

}  // namespace odas
