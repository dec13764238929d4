// SPDX-License-Identifier: MIT
#include "odas/dsp/resampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

namespace odas {
namespace {

constexpr double kTaps = 80;           // of a filter at the lower rate
constexpr double kCutOff = 0.925;      // of the lower Nyquist frequency
constexpr double kKaiserBeta = 10.06;  // 100 dB: 0.1102 (100 - 8.7)
constexpr std::size_t kLanes = 8;      // partial sums of a product, for vectors
// Interpolating between filters that stand 1/P apart errs by (pi c / P)^2 / 8: 1e-6 at 1024.
constexpr double kMostFractions = 1024;
constexpr double kFewestFractions = 16;

/// Modified Bessel function of order 0, by its series.
double bessel_i0(double x) {
  double sum = 1;
  double term = 1;
  for (int k = 1; term > 1e-12 * sum; ++k) {
    term *= (x / (2 * k)) * (x / (2 * k));
    sum += term;
  }
  return sum;
}

double sinc(double x) {
  return std::fabs(x) < 1e-9 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

float product(const float* filter, const float* samples, std::size_t taps) noexcept {
  std::array<float, kLanes> sums{};
  for (std::size_t k = 0; k < taps; k += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += filter[k + lane] * samples[k + lane];
  }
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

/// Taps of a filter at the input's rate: those of the lower rate, a multiple of the lanes.
std::size_t taps_of(std::uint64_t up, std::uint64_t down) {
  if (up == down) return 1;
  const double stretch = std::max(1.0, static_cast<double>(down) / static_cast<double>(up));
  return static_cast<std::size_t>(std::ceil(kTaps * stretch / kLanes)) * kLanes;
}

std::size_t fractions_of(std::uint64_t up, std::uint64_t down) {
  // A filter that is stretched changes more slowly from fraction to fraction.
  const double shrink = std::min(1.0, static_cast<double>(up) / static_cast<double>(down));
  const auto most = static_cast<std::uint64_t>(std::max(kFewestFractions, kMostFractions * shrink));
  return static_cast<std::size_t>(std::min(up, most));
}

}  // namespace

Resampler::Resampler(std::size_t channels, int in_rate, int out_rate, std::size_t max_block, std::size_t hop)
    : up_(static_cast<std::uint64_t>(out_rate / std::gcd(in_rate, out_rate))),
      down_(static_cast<std::uint64_t>(in_rate / std::gcd(in_rate, out_rate))),
      max_block_(max_block),
      hop_(hop),
      taps_(taps_of(up_, down_)),
      fractions_(fractions_of(up_, down_)) {
  // A hop's worth of input that just does not give it, a block, the filter, and the zeros of the end.
  const std::size_t hop_input = hop * down_ / up_ + 2;
  input_ = Grid<float>(channels, 2 * (hop_input + max_block + 2 * taps_));
  quiet_.resize(channels);
  if (taps_ > 1) make_filters();
  reset();
}

void Resampler::make_filters() {
  filters_ = Grid<float>(fractions_ + 1, taps_);
  const double cut_off = kCutOff * std::min(1.0, static_cast<double>(up_) / static_cast<double>(down_));
  const double half = static_cast<double>(taps_) / 2;
  const double window_scale = 1 / bessel_i0(kKaiserBeta);
  std::vector<double> values(taps_);
  for (std::size_t f = 0; f <= fractions_; ++f) {
    const double at = static_cast<double>(f) / static_cast<double>(fractions_) + half - 1;
    double sum = 0;
    for (std::size_t k = 0; k < taps_; ++k) {
      const double t = at - static_cast<double>(k);
      const double inside = std::max(0.0, 1 - (t / half) * (t / half));
      values[k] = sinc(cut_off * t) * bessel_i0(kKaiserBeta * std::sqrt(inside)) * window_scale;
      sum += values[k];
    }
    for (std::size_t k = 0; k < taps_; ++k) filters_[f][k] = static_cast<float>(values[k] / sum);
  }
}

void Resampler::reset() noexcept {
  begin_ = 0;
  end_ = (taps_ - 1) / 2;  // silence came before
  for (std::size_t c = 0; c < input_.rows(); ++c) std::fill_n(input_[c].begin(), end_, 0.0F);
  std::fill(quiet_.begin(), quiet_.end(), 0);
  fraction_ = taken_ = given_ = 0;
  finished_ = false;
}

void Resampler::make_room(std::size_t samples) noexcept {
  if (end_ + samples <= input_.cols()) return;
  // When the rate falls far, the next output may begin beyond what has come.
  const std::size_t shift = std::min(begin_, end_);
  for (std::size_t c = 0; c < input_.rows(); ++c) {
    std::copy_n(input_[c].data() + shift, end_ - shift, input_[c].data());
    quiet_[c] -= std::min(quiet_[c], shift);
  }
  begin_ -= shift;
  end_ -= shift;
  ODAS_EXPECT(end_ + samples <= input_.cols());
}

void Resampler::push(GridView<const float> block) noexcept {
  ODAS_EXPECT(block.rows() == input_.rows() && block.cols() <= max_block_ && !finished_);
  make_room(block.cols());
  for (std::size_t c = 0; c < input_.rows(); ++c) {
    std::copy_n(block[c].data(), block.cols(), input_[c].data() + end_);
    const bool silent = std::all_of(block[c].begin(), block[c].end(), [](float x) { return x == 0; });
    if (!silent) quiet_[c] = end_ + block.cols();
  }
  end_ += block.cols();
  taken_ += block.cols();
}

void Resampler::finish() noexcept {
  if (finished_) return;
  finished_ = true;
  make_room(lookahead());
  for (std::size_t c = 0; c < input_.rows(); ++c) std::fill_n(input_[c].begin() + end_, lookahead(), 0.0F);
  end_ += lookahead();
}

bool Resampler::holds(std::size_t samples) const noexcept {
  if (samples == 0) return true;
  const std::size_t last = begin_ + (fraction_ + (samples - 1) * down_) / up_;
  return last + taps_ <= end_;
}

bool Resampler::pop(GridView<float> hop) noexcept {
  ODAS_EXPECT(hop.rows() == input_.rows() && hop.cols() == hop_);
  if (!holds(hop_)) return false;
  resample(hop_, hop);
  return true;
}

std::size_t Resampler::pop_rest(GridView<float> hop) noexcept {
  const std::uint64_t all = (taken_ * up_ + down_ - 1) / down_;
  const auto rest = static_cast<std::size_t>(std::min<std::uint64_t>(all - given_, hop_));
  ODAS_EXPECT(finished_ && holds(rest));
  resample(rest, hop);
  for (std::size_t c = 0; c < hop.rows(); ++c) {
    std::fill(hop[c].begin() + static_cast<std::ptrdiff_t>(rest), hop[c].end(), 0.0F);
  }
  return rest;
}

void Resampler::resample(std::size_t samples, GridView<float> out) noexcept {
  given_ += samples;
  if (taps_ == 1) {
    for (std::size_t c = 0; c < input_.rows(); ++c) {
      std::copy_n(input_[c].data() + begin_, samples, out[c].data());
    }
    begin_ += samples;
    return;
  }
  for (std::size_t i = 0; i < samples; ++i) {
    const std::uint64_t scaled = fraction_ * fractions_;
    const float* filter = filters_[static_cast<std::size_t>(scaled / up_)].data();
    const auto between = static_cast<float>(scaled % up_) / static_cast<float>(up_);
    for (std::size_t c = 0; c < input_.rows(); ++c) {
      const float* from = input_[c].data() + begin_;
      float y = begin_ >= quiet_[c] ? 0 : product(filter, from, taps_);
      if (between > 0 && begin_ < quiet_[c]) y += between * (product(filter + taps_, from, taps_) - y);
      out[c][i] = y;
    }
    fraction_ += down_;
    begin_ += fraction_ / up_;
    fraction_ %= up_;
  }
}

}  // namespace odas
