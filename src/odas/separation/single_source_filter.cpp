// SPDX-License-Identifier: MIT
#include "odas/separation/single_source_filter.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "odas/base/contract.hpp"

namespace odas {
namespace {

bool is_silent(std::span<const cfloat> row) noexcept {
  return std::all_of(row.begin(), row.end(), [](cfloat w) { return w == cfloat{}; });
}

}  // namespace

SingleSourceFilter::SingleSourceFilter(const SingleSourceFilterConfig& config, const GeneralConfig& general)
    : config_(config),
      epsilon_(std::max(general.epsilon, 1e-30F)),
      parts_(static_cast<std::size_t>(general.size.frame_size) / 2 + 1) {}

void SingleSourceFilter::apply(GridView<const cfloat> spectra, GridView<const float> /*noise_psd*/,
                               std::span<const Track> tracks, const Beamformer& beamformer,
                               GridView<const cfloat> beams, GridView<cfloat> filtered) noexcept {
  ODAS_EXPECT(beams.cols() == parts_.size() && filtered.cols() == parts_.size());
  ODAS_EXPECT(tracks.size() == beams.rows() && tracks.size() == filtered.rows());

  for (std::size_t s = 0; s < tracks.size(); ++s) {
    const std::span<const cfloat> y = beams[s];
    const std::span<cfloat> out = filtered[s];
    if (tracks[s].id == 0) {
      std::fill(out.begin(), out.end(), cfloat{});
      continue;
    }
    const GridView<const cfloat> weights = beamformer.weights(s);
    std::fill(parts_.begin(), parts_.end(), 0.F);
    float heard = 0;
    for (std::size_t m = 0; m < spectra.rows(); ++m) {
      if (is_silent(weights[m])) continue;
      heard += 1;
      const cfloat* w = weights[m].data();
      const cfloat* x = spectra[m].data();
      for (std::size_t k = 0; k < parts_.size(); ++k) parts_[k] += std::norm(w[k]) * std::norm(x[k]);
    }
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const float ratio = std::norm(y[k]) / (heard * parts_[k] + epsilon_);
      const float open = 1 / (1 + std::exp(-config_.g_slope * (ratio - config_.g_mid)));
      out[k] = (config_.g_min + (1 - config_.g_min) * open) * y[k];
    }
  }
}

}  // namespace odas
