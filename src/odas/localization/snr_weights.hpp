// SPDX-License-Identifier: MIT
#pragma once

#include "odas/array/types.hpp"

namespace odas {

/// Weighs each bin of each microphone by how far the sound stands out of the noise, so that fans and hum
/// count for less than speech.
///
/// Method: zeta = xi / (xi + 1), with the a-priori signal-to-noise ratio
/// xi = ((1 - a) (zeta_prev |X_prev|)^2 + a |X|^2) / lambda, a = 0.1, and lambda the noise power.
/// Source: Valin, Michaud, Rouat, "Robust localization and tracking of simultaneous moving sound sources
/// using beamforming and particle filtering", 2007, eqs. 8-9. The ODAS paper (2022) describes this weighting,
/// its code does not do it.
class SnrWeights {
 public:
  SnrWeights(std::size_t mics, std::size_t bins) : kept_(mics, bins) {}

  /// Multiplies the phasors re, im [mic][bin or more] by zeta.
  void apply(GridView<const cfloat> spectra, GridView<const float> noise_psd, GridView<float> re,
             GridView<float> im) noexcept;
  void reset() noexcept { kept_.fill(0); }

 private:
  Grid<float> kept_;  // [mic][bin]: (zeta |X|)^2 of the last hop
};

}  // namespace odas
