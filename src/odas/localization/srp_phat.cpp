// SPDX-License-Identifier: MIT
#include "odas/localization/srp_phat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odas {

SrpPhat::SrpPhat(const GeneralConfig& general, const SslConfig& ssl)
    : epsilon_(general.epsilon),
      plan_(general, ssl),
      table_(static_cast<std::size_t>(general.size.frame_size) / 2 * 2, ssl.interp_rate, plan_.half_lags),
      re_(general.mics.size(), padded(table_.bins())),
      im_(re_.rows(), re_.cols()),
      correlations_(plan_.pairs.size(), plan_.row_size),
      scratch_(lag_scratch_size(table_)),
      search_(plan_) {
  if (ssl.weighting == "snr") weights_.emplace(general.mics.size(), table_.bins());
}

void SrpPhat::locate(GridView<const cfloat> spectra, GridView<const float> noise_psd,
                     std::span<Potential> potentials) noexcept {
  ODAS_EXPECT(spectra.rows() == re_.rows() && spectra.cols() == table_.bins());
  whiten(spectra);
  if (weights_) weights_->apply(spectra, noise_psd, re_, im_);
  lag_products(re_, im_, plan_.pairs, table_, table_.all_bins(), scratch_, correlations_);
  PeakSearch::Peak peak;
  for (std::size_t p = 0; p < potentials.size(); ++p) {
    if (p > 0) cut_out(peak.point);
    peak = search_.strongest(plan_, correlations_, p == 0 ? std::span<float>(power_) : std::span<float>());
    potentials[p] = Potential{plan_.levels.back().directions[peak.point], peak.energy};
  }
}

void SrpPhat::reset() noexcept {
  correlations_.fill(0);
  std::fill(power_.begin(), power_.end(), 0.F);
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

void SrpPhat::cut_out(std::size_t point) noexcept {
  const SearchPlan::Level& finest = plan_.levels.back();
  const std::size_t last = 2 * plan_.half_lags;
  for (std::size_t q = 0; q < plan_.pairs.size(); ++q) {
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
