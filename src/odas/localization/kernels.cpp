// SPDX-License-Identifier: MIT
#include "odas/localization/kernels.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

// Vectors whose length the compiler does not know cannot stand in the arrays below: on ARM, NEON does.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "odas/localization/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace odas {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kKernelLanes>;
using Vector = hn::Vec<Floats>;

/// C = X_i conj(X_j), real and imaginary parts apart.
void CrossSpectrum(const float* HWY_RESTRICT ri, const float* HWY_RESTRICT ii, const float* HWY_RESTRICT rj,
                   const float* HWY_RESTRICT ij, std::size_t n, float* HWY_RESTRICT re,
                   float* HWY_RESTRICT im) {
  const Floats d;
  for (std::size_t k = 0; k < n; k += hn::Lanes(d)) {
    const auto a = hn::LoadU(d, ri + k);
    const auto b = hn::LoadU(d, ii + k);
    const auto c = hn::LoadU(d, rj + k);
    const auto e = hn::LoadU(d, ij + k);
    hn::StoreU(hn::MulAdd(a, c, hn::Mul(b, e)), d, re + k);
    hn::StoreU(hn::NegMulAdd(a, e, hn::Mul(b, c)), d, im + k);
  }
}

/// For two pairs at once and one vector of lags: the even part (cosines) and the odd part (sines).
void TwoPairs(const float* HWY_RESTRICT re0, const float* HWY_RESTRICT im0, const float* HWY_RESTRICT re1,
              const float* HWY_RESTRICT im1, const float* HWY_RESTRICT cos, const float* HWY_RESTRICT sin,
              std::span<const std::uint16_t> bins, std::size_t stride, float* HWY_RESTRICT parts) {
  const Floats d;
  const std::size_t lanes = hn::Lanes(d);
  Vector even0 = hn::Zero(d);
  Vector odd0 = hn::Zero(d);
  Vector even1 = hn::Zero(d);
  Vector odd1 = hn::Zero(d);
  for (const std::size_t k : bins) {
    const auto c = hn::LoadU(d, cos + k * stride);
    const auto s = hn::LoadU(d, sin + k * stride);
    even0 = hn::MulAdd(hn::Set(d, re0[k]), c, even0);
    odd0 = hn::MulAdd(hn::Set(d, im0[k]), s, odd0);
    even1 = hn::MulAdd(hn::Set(d, re1[k]), c, even1);
    odd1 = hn::MulAdd(hn::Set(d, im1[k]), s, odd1);
  }
  hn::StoreU(even0, d, parts);
  hn::StoreU(odd0, d, parts + lanes);
  hn::StoreU(even1, d, parts + 2 * lanes);
  hn::StoreU(odd1, d, parts + 3 * lanes);
}

void LagProducts(GridView<const float> re, GridView<const float> im, std::span<const Pair> pairs,
                 const LagTable& table, std::span<const std::uint16_t> bins, float* HWY_RESTRICT scratch,
                 GridView<float> out) {
  const Floats d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t row = padded(table.bins());
  const std::size_t half = table.half_lags();
  const std::size_t stride = table.cos().cols();
  float* cross[4] = {scratch, scratch + row, scratch + 2 * row, scratch + 3 * row};
  float* parts = scratch + 4 * row;
  for (std::size_t q = 0; q < pairs.size(); q += 2) {
    const std::size_t together = q + 1 < pairs.size() ? 2 : 1;
    for (std::size_t t = 0; t < together; ++t) {
      const auto [i, j] = pairs[q + t];
      CrossSpectrum(re.data() + i * re.stride(), im.data() + i * im.stride(), re.data() + j * re.stride(),
                    im.data() + j * im.stride(), row, cross[2 * t], cross[2 * t + 1]);
    }
    const std::size_t second = together == 2 ? 2 : 0;  // an odd last pair is its own companion
    for (std::size_t l = 0; l <= half; l += lanes) {
      TwoPairs(cross[0], cross[1], cross[second], cross[second + 1], table.cos().data() + l,
               table.sin().data() + l, bins, stride, parts);
      const std::size_t n = std::min(lanes, half + 1 - l);
      for (std::size_t t = 0; t < together; ++t) {
        float* x = out.data() + (q + t) * out.stride() + half;
        const float* even = parts + 2 * t * lanes;
        const float* odd = even + lanes;
        for (std::size_t v = 0; v < n; ++v) {
          x[l + v] = even[v] - odd[v];
          *(x - (l + v)) = even[v] + odd[v];
        }
      }
    }
  }
}

/// For `kVectors` vectors of columns, the first of which begins at `x`.
template <std::size_t kVectors>
void MaxBlock(const float* HWY_RESTRICT x, std::size_t width, float* HWY_RESTRICT y) {
  const Floats d;
  const std::size_t lanes = hn::Lanes(d);
  Vector best[kVectors];
  for (std::size_t v = 0; v < kVectors; ++v) best[v] = hn::LoadU(d, x + v * lanes);
  for (std::size_t k = 1; k < width; ++k) {
    for (std::size_t v = 0; v < kVectors; ++v) best[v] = hn::Max(best[v], hn::LoadU(d, x + k + v * lanes));
  }
  for (std::size_t v = 0; v < kVectors; ++v) hn::StoreU(best[v], d, y + v * lanes);
}

void SlidingMax(const float* HWY_RESTRICT x, std::size_t first, std::size_t last, std::size_t delta,
                float* HWY_RESTRICT y) {
  const std::size_t lanes = hn::Lanes(Floats());
  const std::size_t width = 2 * delta + 1;
  std::size_t n = first;
  for (; n + 4 * lanes <= last + lanes; n += 4 * lanes) MaxBlock<4>(x + n - delta, width, y + n);
  for (; n <= last; n += lanes) MaxBlock<1>(x + n - delta, width, y + n);
}

/// Sums for `kVectors` vectors of candidates: the sums stay in registers while the pairs go by.
template <std::size_t kVectors>
void GatherBlock(std::span<const float* const> rows, GridView<const std::uint16_t> columns, std::size_t first,
                 float* HWY_RESTRICT sums) {
  const Floats d;
  const hn::Rebind<std::int32_t, Floats> di;
  const hn::Rebind<std::uint16_t, Floats> d16;
  const std::size_t lanes = hn::Lanes(d);
  Vector acc[kVectors];
  for (std::size_t v = 0; v < kVectors; ++v) acc[v] = hn::Zero(d);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const std::uint16_t* column = columns.data() + q * columns.stride() + first;
    for (std::size_t v = 0; v < kVectors; ++v) {
      const auto index = hn::PromoteTo(di, hn::LoadU(d16, column + v * lanes));
      acc[v] = hn::Add(acc[v], hn::GatherIndex(d, rows[q], index));
    }
  }
  for (std::size_t v = 0; v < kVectors; ++v) hn::StoreU(acc[v], d, sums + first + v * lanes);
}

void GatherSums(std::span<const float* const> rows, GridView<const std::uint16_t> columns,
                std::span<float> sums) {
  const std::size_t lanes = hn::Lanes(Floats());
  const std::size_t n = columns.cols();
  std::size_t c = 0;
  for (; c + 4 * lanes <= n; c += 4 * lanes) GatherBlock<4>(rows, columns, c, sums.data());
  for (; c + lanes <= n; c += lanes) GatherBlock<1>(rows, columns, c, sums.data());
}

const char* TargetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace odas
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace odas {

HWY_EXPORT(LagProducts);
HWY_EXPORT(SlidingMax);
HWY_EXPORT(GatherSums);
HWY_EXPORT(TargetName);

LagTable::LagTable(std::size_t frame_size, int interp_rate, std::size_t half_lags)
    : half_lags_(half_lags),
      cos_(frame_size / 2 + 1, padded(half_lags + 1)),
      sin_(frame_size / 2 + 1, padded(half_lags + 1)),
      all_bins_(frame_size / 2 + 1) {
  std::iota(all_bins_.begin(), all_bins_.end(), std::uint16_t{0});
  const std::size_t last = frame_size / 2;
  const std::size_t period = frame_size * static_cast<std::size_t>(interp_rate);
  for (std::size_t k = 0; k <= last; ++k) {
    const bool counts_once = k == 0 || (k == last && interp_rate == 1);
    const double scale = (counts_once ? 1.0 : 2.0) / static_cast<double>(frame_size);
    for (std::size_t l = 0; l <= half_lags; ++l) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(k * l % period) / static_cast<double>(period);
      cos_[k][l] = static_cast<float>(scale * std::cos(angle));
      sin_[k][l] = static_cast<float>(scale * std::sin(angle));
    }
  }
}

std::size_t lag_scratch_size(const LagTable& table) noexcept {
  return 4 * padded(table.bins()) + 4 * kKernelLanes;
}

void lag_products(GridView<const float> re, GridView<const float> im, std::span<const Pair> pairs,
                  const LagTable& table, std::span<const std::uint16_t> bins, std::span<float> scratch,
                  GridView<float> out) noexcept {
  ODAS_EXPECT(re.cols() == padded(table.bins()) && im.cols() == re.cols());
  ODAS_EXPECT(scratch.size() >= lag_scratch_size(table));
  ODAS_EXPECT(bins.empty() || bins.back() < table.bins());
  ODAS_EXPECT(out.rows() >= pairs.size() && out.cols() > 2 * table.half_lags());
  HWY_DYNAMIC_DISPATCH(LagProducts)(re, im, pairs, table, bins, scratch.data(), out);
}

void sliding_max(const float* x, std::size_t first, std::size_t last, std::size_t delta, float* y) noexcept {
  ODAS_EXPECT(delta <= first);
  HWY_DYNAMIC_DISPATCH(SlidingMax)(x, first, last, delta, y);
}

void gather_sums(std::span<const float* const> rows, GridView<const std::uint16_t> columns,
                 std::span<float> sums) noexcept {
  ODAS_EXPECT(columns.cols() % kKernelLanes == 0 && sums.size() >= columns.cols());
  HWY_DYNAMIC_DISPATCH(GatherSums)(rows, columns, sums);
}

const char* kernel_target() noexcept { return HWY_DYNAMIC_DISPATCH(TargetName)(); }

}  // namespace odas
#endif
