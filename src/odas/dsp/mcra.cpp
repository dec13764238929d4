// SPDX-License-Identifier: MIT
#include "odas/dsp/mcra.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

/// The bin of a whole spectrum that mirrors itself at bin 0 and at the last one.
std::size_t mirror(std::ptrdiff_t bin, std::size_t bins) noexcept {
  const auto last = static_cast<std::ptrdiff_t>(bins) - 1;
  if (last == 0) return 0;
  const std::ptrdiff_t turn = std::abs(bin) % (2 * last);
  return static_cast<std::size_t>(turn <= last ? turn : 2 * last - turn);
}

float sum_of(std::span<const float> values) noexcept {
  return std::accumulate(values.begin(), values.end(), 0.F);
}

}  // namespace

Mcra::Mcra(const McraConfig& config, std::size_t channels, std::size_t bins)
    : alpha_s_(config.alpha_s),
      delta_(config.delta),
      alpha_d_(config.alpha_d),
      period_(config.l + 2),
      warm_up_(static_cast<int>(std::ceil(1 / std::max(config.alpha_s, 1e-3F)))),
      window_(static_cast<std::size_t>(config.b)),
      mirrored_(bins + window_.size() - 1),
      extended_(mirrored_.size()),
      over_bins_(bins),
      power_(bins),
      heard_(channels),
      age_(channels),
      smoothed_(channels, bins),
      minimum_(channels, bins),
      next_minimum_(channels, bins),
      psd_(channels, bins) {
  const auto taps = static_cast<double>(window_.size());
  for (std::size_t n = 0; n < window_.size(); ++n) {
    // The sum of the Hann window over its inner points is (taps + 1) / 2.
    const double hann = 0.5 * (1 - std::cos(2 * M_PI * static_cast<double>(n + 1) / (taps + 1)));
    window_[n] = static_cast<float>(hann * 2 / (taps + 1));
  }
  const std::ptrdiff_t before = (config.b - 1) / 2;
  for (std::size_t i = 0; i < mirrored_.size(); ++i) {
    mirrored_[i] = mirror(static_cast<std::ptrdiff_t>(i) - before, bins);
  }
}

void Mcra::update(GridView<const cfloat> spectra) noexcept {
  ODAS_EXPECT(spectra.rows() == psd_.rows() && spectra.cols() == psd_.cols());
  for (std::size_t c = 0; c < spectra.rows(); ++c) {
    const cfloat* x = spectra[c].data();
    for (std::size_t k = 0; k < power_.size(); ++k) power_[k] = std::norm(x[k]);
    update(c, power_);
  }
}

void Mcra::update(std::size_t channel, std::span<const float> power) noexcept {
  ODAS_EXPECT(channel < psd_.rows() && power.size() == psd_.cols());
  const float total = sum_of(power);
  if (!std::isfinite(total) || (heard_[channel] == 0 && total == 0)) return;
  smooth(power);

  // At first every hop weighs the same: no single one, with its dips, sets the minimum.
  const bool warming_up = heard_[channel] < warm_up_;
  if (warming_up) ++heard_[channel];
  const float equal_part = 1 / static_cast<float>(heard_[channel]);
  const float alpha_s = warming_up ? std::max(alpha_s_, equal_part) : alpha_s_;
  const float alpha_d = warming_up ? std::max(alpha_d_, equal_part) : alpha_d_;
  const bool turn = !warming_up && ++age_[channel] >= period_;
  if (turn) age_[channel] = 0;

  // Each loop so that the compiler sees it has no branch and no two arrays in one place.
  const std::size_t bins = power.size();
  const float* __restrict p = power.data();
  const float* __restrict over_bins = over_bins_.data();
  float* __restrict s = smoothed_[channel].data();
  float* __restrict minimum = minimum_[channel].data();
  float* __restrict next = next_minimum_[channel].data();
  float* __restrict psd = psd_[channel].data();
  for (std::size_t k = 0; k < bins; ++k) s[k] += alpha_s * (over_bins[k] - s[k]);
  if (warming_up) {
    for (std::size_t k = 0; k < bins; ++k) {
      minimum[k] = next[k] = s[k];
      psd[k] += alpha_d * (p[k] - psd[k]);
    }
    return;
  }
  if (turn) {
    std::copy_n(next, bins, minimum);
    std::copy_n(s, bins, next);
  }
  const float delta = delta_;
  for (std::size_t k = 0; k < bins; ++k) {
    minimum[k] = s[k] < minimum[k] ? s[k] : minimum[k];
    next[k] = s[k] < next[k] ? s[k] : next[k];
    const float step = alpha_d * (p[k] - psd[k]);
    const float if_quiet = s[k] < delta * minimum[k] ? step : 0;
    psd[k] += psd[k] > s[k] ? step : if_quiet;
  }
}

void Mcra::smooth(std::span<const float> power) noexcept {
  for (std::size_t i = 0; i < extended_.size(); ++i) extended_[i] = power[mirrored_[i]];
  std::fill(over_bins_.begin(), over_bins_.end(), 0.F);
  for (std::size_t n = 0; n < window_.size(); ++n) {
    for (std::size_t k = 0; k < over_bins_.size(); ++k) over_bins_[k] += window_[n] * extended_[k + n];
  }
}

void Mcra::reset(std::size_t channel, std::span<const float> known) noexcept {
  ODAS_EXPECT(channel < psd_.rows() && known.size() == psd_.cols());
  reset(channel);
  const float total = sum_of(known);
  if (!std::isfinite(total) || !(total > 0)) return;
  heard_[channel] = warm_up_;
  for (Grid<float>* state : {&smoothed_, &minimum_, &next_minimum_, &psd_}) {
    std::copy(known.begin(), known.end(), (*state)[channel].begin());
  }
}

void Mcra::reset(std::size_t channel) noexcept {
  heard_[channel] = 0;
  age_[channel] = 0;
  for (Grid<float>* state : {&smoothed_, &minimum_, &next_minimum_, &psd_}) {
    std::fill((*state)[channel].begin(), (*state)[channel].end(), 0.F);
  }
}

void Mcra::reset() noexcept {
  for (std::size_t c = 0; c < psd_.rows(); ++c) reset(c);
}

}  // namespace odas
