// SPDX-License-Identifier: MIT
#include "odas/localization/config.hpp"

namespace odas {

Schema ScanConfig::schema() {
  static const std::vector<Field> fields{
      field<&ScanConfig::level>("level", "", {0, 5},
                                "subdivisions of the icosahedron: 10 * 4^level + 2 directions"),
      field<&ScanConfig::delta>("delta", "interpolated samples", {-1000, 1000},
                                "half-width of the sliding maximum over lags; negative: automatic, per pair"),
  };
  return fields;
}

Schema SslConfig::schema() {
  static const std::vector<Field> fields{
      field<&SslConfig::mode>(
          "mode", "", kAny,
          "how directions are found: srp_phat, as ODAS; srp_clean, from onsets over the noise, "
          "off the grid, with evidence and uncertainty",
          {"srp_phat", "srp_clean"}),
      field<&SslConfig::n_pots>("nPots", "", {1, 64}, "potential directions found in each hop"),
      field<&SslConfig::n_matches>("nMatches", "", {1, 10000},
                                   "coarse directions that each fine direction is reached from"),
      field<&SslConfig::prob_min>("probMin", "", {0, 0.999},
                                  "what share of the true delays an automatic delta covers"),
      field<&SslConfig::n_refined_levels>("nRefinedLevels", "", {0, 6},
                                          "how finely an automatic delta is trained"),
      field<&SslConfig::interp_rate>("interpRate", "", {1, 64}, "oversampling of the cross-correlation"),
      field<&SslConfig::scans>("scans", "", kAny, "the search, from coarse to fine"),
      field<&SslConfig::weighting>("weighting", "", kAny,
                                   "of srp_phat: none: all bins count alike, as in ODAS; snr: each bin "
                                   "counts by its signal-to-noise ratio",
                                   {"none", "snr"}),
      field<&SslConfig::averaging>(
          "averaging", "ms", {0, 10000},
          "time constant over which srp_clean averages faint correlations; clear ones need less"),
  };
  return fields;
}

}  // namespace odas
