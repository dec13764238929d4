// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// Neighbouring bins are worked on side by side, this many in a block.
inline constexpr std::size_t kBlockBins = 16;

[[nodiscard]] constexpr std::size_t blocks_for(std::size_t bins) noexcept {
  return (bins + kBlockBins - 1) / kBlockBins;
}

/// Complex numbers of all bins: [block][row], each row being 16 real parts and then 16 imaginary parts. Rows
/// are microphones (a vector in each bin) or entries of a packed matrix. Bins past the last hold what they
/// were given: zero at first.
class BinBlocks {
 public:
  BinBlocks() = default;
  BinBlocks(std::size_t rows, std::size_t bins)
      : rows_(rows), bins_(bins), values_(blocks_for(bins) * rows * 2 * kBlockBins) {}

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t bins() const noexcept { return bins_; }
  [[nodiscard]] std::size_t blocks() const noexcept { return blocks_for(bins_); }

  /// 16 real parts; the 16 imaginary parts follow.
  [[nodiscard]] float* at(std::size_t block, std::size_t row) noexcept {
    return values_.data() + (block * rows_ + row) * 2 * kBlockBins;
  }
  [[nodiscard]] const float* at(std::size_t block, std::size_t row) const noexcept {
    return values_.data() + (block * rows_ + row) * 2 * kBlockBins;
  }

  [[nodiscard]] cfloat get(std::size_t row, std::size_t bin) const noexcept {
    const float* p = at(bin / kBlockBins, row) + bin % kBlockBins;
    return {p[0], p[kBlockBins]};
  }
  void set(std::size_t row, std::size_t bin, cfloat value) noexcept {
    float* p = at(bin / kBlockBins, row) + bin % kBlockBins;
    p[0] = value.real();
    p[kBlockBins] = value.imag();
  }
  void set_row(std::size_t row, std::span<const cfloat> values) noexcept {
    const std::size_t whole = values.size() / kBlockBins;
    for (std::size_t b = 0; b < whole; ++b) {
      float* p = at(b, row);
      const cfloat* z = values.data() + b * kBlockBins;
      for (std::size_t i = 0; i < kBlockBins; ++i) {
        p[i] = z[i].real();
        p[i + kBlockBins] = z[i].imag();
      }
    }
    for (std::size_t k = whole * kBlockBins; k < values.size(); ++k) set(row, k, values[k]);
  }

  void fill(float value) noexcept { std::fill(values_.begin(), values_.end(), value); }

 private:
  std::size_t rows_ = 0;
  std::size_t bins_ = 0;
  std::vector<float> values_;
};

/// One real number a bin, padded to whole blocks.
class BinReals {
 public:
  BinReals() = default;
  explicit BinReals(std::size_t bins) : bins_(bins), values_(blocks_for(bins) * kBlockBins) {}

  [[nodiscard]] std::size_t bins() const noexcept { return bins_; }
  [[nodiscard]] float* data() noexcept { return values_.data(); }
  [[nodiscard]] const float* data() const noexcept { return values_.data(); }
  [[nodiscard]] std::span<float> padded() noexcept { return values_; }
  [[nodiscard]] std::span<const float> padded() const noexcept { return values_; }
  float& operator[](std::size_t bin) noexcept { return values_[bin]; }
  float operator[](std::size_t bin) const noexcept { return values_[bin]; }
  void fill(float value) noexcept { std::fill(values_.begin(), values_.end(), value); }

 private:
  std::size_t bins_ = 0;
  std::vector<float> values_;
};

}  // namespace odas
