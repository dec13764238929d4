// SPDX-License-Identifier: MIT
#include "odas/scene/correlation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "odas/dsp/real_fft.hpp"

namespace odas {
namespace {

/// A block of FFT is this many times what must be spared for the lags: long enough to waste little.
constexpr std::size_t kBlocks = 4;

/// Copies x[begin], ..., with silence beyond the ends of x.
void copy_from(std::span<const float> x, long begin, std::span<float> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    const long at = begin + static_cast<long>(i);
    out[i] = at >= 0 && at < static_cast<long>(x.size()) ? x[static_cast<std::size_t>(at)] : 0.F;
  }
}

}  // namespace

std::vector<double> correlate(std::span<const float> a, std::span<const float> b, long first,
                              std::size_t count) {
  const std::size_t size = std::bit_ceil(kBlocks * count);
  const std::size_t block = size - count + 1;
  RealFft fft(size);
  std::vector<cfloat> of_a(size / 2 + 1);
  std::vector<double> sum(count, 0.0);
  for (std::size_t begin = 0; begin < b.size(); begin += block) {
    copy_from(a, static_cast<long>(begin) + first, fft.time());
    fft.forward();
    std::ranges::copy(fft.bins(), of_a.begin());
    const std::size_t length = std::min(block, b.size() - begin);
    std::ranges::fill(fft.time(), 0.F);
    std::ranges::copy(b.subspan(begin, length), fft.time().begin());
    fft.forward();
    for (std::size_t k = 0; k < of_a.size(); ++k) fft.bins()[k] = of_a[k] * std::conj(fft.bins()[k]);
    fft.inverse();
    for (std::size_t i = 0; i < count; ++i) sum[i] += static_cast<double>(fft.time()[i]);
  }
  return sum;
}

std::size_t best_lag(std::span<const float> a, std::span<const float> b, std::size_t count) {
  const auto alike = correlate(a, b, 0, count);
  const auto best = std::ranges::max_element(alike, {}, [](double c) { return std::abs(c); });
  return static_cast<std::size_t>(best - alike.begin());
}

std::vector<float> filter(std::span<const float> x, std::span<const double> taps, std::size_t advance) {
  const std::size_t size = std::bit_ceil(kBlocks * taps.size());
  const std::size_t block = size - taps.size() + 1;
  RealFft fft(size);
  std::ranges::fill(fft.time(), 0.F);
  std::ranges::transform(taps, fft.time().begin(), [](double tap) { return static_cast<float>(tap); });
  fft.forward();
  const std::vector<cfloat> response(fft.bins().begin(), fft.bins().end());
  std::vector<float> y(x.size());
  for (std::size_t begin = 0; begin < x.size(); begin += block) {
    // Overlap-save: the first taps.size() - 1 of the outputs are wrapped and thrown away.
    const std::size_t before = taps.size() - 1;
    copy_from(x, static_cast<long>(begin + advance) - static_cast<long>(before), fft.time());
    fft.forward();
    for (std::size_t k = 0; k < response.size(); ++k) fft.bins()[k] *= response[k];
    fft.inverse();
    const std::size_t length = std::min(block, x.size() - begin);
    std::ranges::copy(fft.time().subspan(before, length), y.begin() + static_cast<long>(begin));
  }
  return y;
}

}  // namespace odas
