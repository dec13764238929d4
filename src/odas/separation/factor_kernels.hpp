// SPDX-License-Identifier: MIT
// Cholesky factors of Hermitian matrices, one a bin, compiled for several instruction sets and chosen at run
// time.
#pragma once

#include <cstddef>

#include "odas/separation/bin_blocks.hpp"

namespace odas {

/// L of R = L L^H, packed: column by column, each from its diagonal down.
[[nodiscard]] constexpr std::size_t factor_rows(std::size_t mics) noexcept { return mics * (mics + 1) / 2; }
/// Where entry (row, col) of a packed factor stands, row >= col.
[[nodiscard]] constexpr std::size_t factor_row(std::size_t mics, std::size_t row, std::size_t col) noexcept {
  return col * mics - col * (col + 1) / 2 + row;
}

/// R <- keep R + v v^H. The factor stays one whatever rounding does: nothing is subtracted (Golub and Van
/// Loan, "Matrix computations", 6.5.4). `v` is spoilt. Cost: mics^2 complex products a bin.
void factor_update(BinBlocks& factor, const BinReals& keep, BinBlocks& v) noexcept;

/// R <- R + amplitude^2 e e^H, e: the unit vector of microphone `mic`. `scratch` is spoilt.
void factor_load(BinBlocks& factor, const BinReals& amplitude, std::size_t mic, BinBlocks& scratch) noexcept;

/// v <- L^-1 v; norm <- |L^-1 v|^2, which is v^H R^-1 v.
void factor_forward(const BinBlocks& factor, BinBlocks& v, BinReals& norm) noexcept;

/// v <- L^-H v: after factor_forward, R^-1 v.
void factor_backward(const BinBlocks& factor, BinBlocks& v) noexcept;

/// out <- a^H b.
void inner_product(const BinBlocks& a, const BinBlocks& b, BinBlocks& out) noexcept;

/// c <- c + gain (x conj(x_reference) - c): the column `reference` of a recursive covariance.
void column_update(BinBlocks& c, const BinReals& gain, const BinBlocks& x, std::size_t reference) noexcept;

}  // namespace odas
