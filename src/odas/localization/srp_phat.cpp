// SPDX-License-Identifier: MIT
#include "odas/localization/srp_phat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odas {
namespace {

std::size_t largest_cell(const SearchPlan& plan) {
  std::size_t largest = 0;
  for (const auto& level : plan.levels) {
    for (const auto& cell : level.cells) largest = std::max(largest, cell.columns.cols());
  }
  return largest;
}

}  // namespace

SrpPhat::SrpPhat(const GeneralConfig& general, const SslConfig& ssl)
    : epsilon_(general.epsilon),
      plan_(general, ssl),
      table_(static_cast<std::size_t>(general.size.frame_size) / 2 * 2, ssl.interp_rate, plan_.half_lags),
      re_(general.mics.size(), padded(table_.bins())),
      im_(re_.rows(), re_.cols()),
      correlations_(plan_.pairs.size(), plan_.row_size),
      maxima_(plan_.pairs.size(), plan_.row_size),
      scratch_(lag_scratch_size(table_)),
      rows_(plan_.pairs.size()),
      sums_(largest_cell(plan_)) {
  if (ssl.weighting == "snr") weights_.emplace(general.mics.size(), table_.bins());
}

void SrpPhat::locate(GridView<const cfloat> spectra, GridView<const float> noise_psd,
                     std::span<Potential> potentials) noexcept {
  ODAS_EXPECT(spectra.rows() == re_.rows() && spectra.cols() == table_.bins());
  whiten(spectra);
  if (weights_) weights_->apply(spectra, noise_psd, re_, im_);
  lag_products(re_, im_, plan_.pairs, table_, scratch_, correlations_);
  for (std::size_t p = 0; p < potentials.size(); ++p) {
    if (p > 0) cut_out(winner_);
    first_search_ = p == 0;
    potentials[p] = search();
  }
}

void SrpPhat::reset() noexcept {
  correlations_.fill(0);
  maxima_.fill(0);
  std::fill(power_.begin(), power_.end(), 0.F);
  winner_ = 0;
  if (weights_) weights_->reset();
}

void SrpPhat::whiten(GridView<const cfloat> spectra) noexcept {
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    const std::span<const cfloat> x = spectra[m];
    float* re = re_[m].data();
    float* im = im_[m].data();
    for (std::size_t k = 0; k < x.size(); ++k) {
      const float magnitude = std::sqrt(x[k].real() * x[k].real() + x[k].imag() * x[k].imag()) + epsilon_;
      const bool finite = magnitude <= std::numeric_limits<float>::max();
      re[k] = finite ? x[k].real() / magnitude : 0.F;
      im[k] = finite ? x[k].imag() / magnitude : 0.F;
    }
  }
}

Potential SrpPhat::search() noexcept {
  std::size_t winner = 0;
  float energy = 0;
  for (std::size_t l = 0; l < plan_.levels.size(); ++l) {
    const SearchPlan::Level& level = plan_.levels[l];
    for (std::size_t q = 0; q < rows_.size(); ++q) {
      rows_[q] = correlations_[q].data();
      if (level.deltas[q] == 0) continue;
      sliding_max(rows_[q], level.first[q], level.last[q], level.deltas[q], maxima_[q].data());
      rows_[q] = maxima_[q].data();
    }
    const SearchPlan::Cell& cell = level.cells[l == 0 ? 0 : winner];
    gather_sums(rows_, cell.columns, sums_);
    if (l == 0 && first_search_ && !power_.empty()) draw_power_map(cell);
    std::size_t best = 0;
    energy = -std::numeric_limits<float>::infinity();
    for (std::size_t c = 0; c < cell.points.size(); ++c) {
      const float mean = sums_[c] / cell.pairs[c];
      if (mean > energy) {
        energy = mean;
        best = c;
      }
    }
    // Where all was cut out there is nothing to find: E is 0, and no direction is better than another. Then
    // the number of the coarse winner stands, in the finest grid too, as ODAS prints it.
    if (energy != 0 || l == 0) winner = cell.points[best];
  }
  winner_ = winner;
  return {plan_.levels.back().directions[winner], energy};
}

void SrpPhat::draw_power_map(const SearchPlan::Cell& cell) noexcept {
  for (std::size_t c = 0; c < cell.points.size(); ++c) power_[cell.points[c]] = sums_[c] / cell.pairs[c];
}

void SrpPhat::cut_out(std::size_t point) noexcept {
  const SearchPlan::Level& finest = plan_.levels.back();
  const std::size_t last = 2 * plan_.half_lags;
  for (std::size_t q = 0; q < rows_.size(); ++q) {
    float* x = correlations_[q].data();
    const auto peak = static_cast<std::size_t>(static_cast<int>(plan_.half_lags) + plan_.fine_lags[point][q]);
    const float height = x[peak];
    for (std::size_t n = peak; n-- > 0 && x[n] <= height;) x[n] = 0;
    for (std::size_t n = peak + 1; n <= last && x[n] <= height; ++n) x[n] = 0;
    const std::size_t delta = finest.deltas[q];
    std::fill(x + peak - delta, x + peak + delta + 1, 0.F);
  }
}

}  // namespace odas
