// SPDX-License-Identifier: MIT
#include "odas/separation/beam_report.hpp"

#include <cmath>
#include <limits>

namespace odas {

float white_noise_gain_db(GridView<const cfloat> weights) noexcept {
  float sum = 0;
  int bins = 0;
  for (std::size_t k = 0; k < weights.cols(); ++k) {
    float power = 0;
    for (std::size_t m = 0; m < weights.rows(); ++m) power += std::norm(weights[m][k]);
    if (!(power > 0)) continue;
    sum -= 10 * std::log10(power);
    ++bins;
  }
  return bins > 0 ? sum / static_cast<float>(bins) : std::numeric_limits<float>::quiet_NaN();
}

}  // namespace odas
