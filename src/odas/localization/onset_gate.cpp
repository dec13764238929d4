// SPDX-License-Identifier: MIT
#include "odas/localization/onset_gate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odas {

OnsetGate::OnsetGate(std::size_t mics, std::size_t bins, float hop_s, float bin_hz)
    : over_noise_(1 + 4 / std::sqrt(static_cast<float>(mics))),
      slope_(bins),
      echo_(bins),
      weights_(bins),
      diffuse_(bins),
      power_(bins),
      noise_(bins) {
  constexpr float kReverberationTime = 0.5F;  // s
  constexpr float kLowest = 200;              // Hz
  decay_ = std::pow(10.F, -6 * hop_s / kReverberationTime);
  for (std::size_t k = 0; k < bins; ++k) {
    const auto bin = static_cast<float>(k);
    slope_[k] = bin * bin_hz < kLowest ? 0 : bin / static_cast<float>(bins - 1);
  }
}

void OnsetGate::update(GridView<const cfloat> spectra, GridView<const float> noise_psd) noexcept {
  constexpr float kPull = 2.5F;
  const std::size_t bins = weights_.size();
  ODAS_EXPECT(spectra.cols() == bins && noise_psd.cols() == bins && noise_psd.rows() == spectra.rows());
  std::fill(power_.begin(), power_.end(), 0.F);
  std::fill(noise_.begin(), noise_.end(), 0.F);
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    const cfloat* x = spectra[m].data();
    const float* n = noise_psd[m].data();
    for (std::size_t k = 0; k < bins; ++k) {
      power_[k] += x[k].real() * x[k].real() + x[k].imag() * x[k].imag();
      noise_[k] += n[k];
    }
  }
  for (std::size_t k = 0; k < bins; ++k) {
    const float power = power_[k];
    const bool finite = power <= std::numeric_limits<float>::max();
    const float rest = power - over_noise_ * noise_[k] - echo_[k];
    weights_[k] = finite && rest > 0 ? slope_[k] * rest / power : 0.F;
    diffuse_[k] = weights_[k] > 0 ? weights_[k] * (kPull * noise_[k] + echo_[k]) / power : 0.F;
    echo_[k] = decay_ * (finite ? std::max(echo_[k], power) : echo_[k]);
  }
}

void OnsetGate::reset() noexcept {
  std::fill(echo_.begin(), echo_.end(), 0.F);
  std::fill(weights_.begin(), weights_.end(), 0.F);
  std::fill(diffuse_.begin(), diffuse_.end(), 0.F);
}

}  // namespace odas
