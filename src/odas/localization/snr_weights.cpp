// SPDX-License-Identifier: MIT
#include "odas/localization/snr_weights.hpp"

namespace odas {

void SnrWeights::apply(GridView<const cfloat> spectra, GridView<const float> noise_psd, GridView<float> re,
                       GridView<float> im) noexcept {
  ODAS_EXPECT(noise_psd.rows() == spectra.rows() && noise_psd.cols() == spectra.cols());
  constexpr float kNew = 0.1F;
  constexpr float kLeastNoise = 1e-30F;
  for (std::size_t m = 0; m < spectra.rows(); ++m) {
    for (std::size_t k = 0; k < spectra.cols(); ++k) {
      const cfloat x = spectra[m][k];
      const float power = x.real() * x.real() + x.imag() * x.imag();
      const float xi = ((1 - kNew) * kept_[m][k] + kNew * power) / (noise_psd[m][k] + kLeastNoise);
      const float zeta = xi / (xi + 1);
      const bool finite = zeta >= 0 && zeta <= 1;  // a power that overflowed counts for nothing
      const float weight = finite ? zeta : 0.F;
      kept_[m][k] = finite ? weight * weight * power : 0.F;
      re[m][k] *= weight;
      im[m][k] *= weight;
    }
  }
}

}  // namespace odas
