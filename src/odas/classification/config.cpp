// SPDX-License-Identifier: MIT
#include "odas/classification/config.hpp"

namespace odas {

Schema ClassifyConfig::schema() {
  using C = ClassifyConfig;
  static const std::vector<Field> fields{
      field<&C::mode>("mode", "", kAny, "how speech is told from other sounds", {"pitch"}),
      field<&C::frame_size>("frameSize", "samples", {2, 1048576}, "analysis frame"),
      field<&C::win_size>("winSize", "lags", {1, 1000}, "half-width of the peak test"),
      field<&C::tau_min>("tauMin", "lags", kPositive, "shortest pitch period"),
      field<&C::tau_max>("tauMax", "lags", kPositive, "longest pitch period"),
      field<&C::delta_tau_max>("deltaTauMax", "lags", kNotNegative, "largest step of a continuous pitch"),
      field<&C::alpha>("alpha", "", kUnit, "weight of the new value in the pitch's slope"),
      field<&C::gamma>("gamma", "", kUnit, "weight of the new value in the share of voiced hops"),
      field<&C::phi_min>("phiMin", "", kNotNegative, "slope from which a pitch counts as moving"),
      field<&C::r0>("r0", "", kUnit, "share of voiced hops from which a source is speech"),
      field<&C::in_tracks>("inTracks", "", kAny,
                           "write the class into the tracks, too, which takes the separated voices"),
      field<&C::voicing_min>("voicingMin", "", kUnit,
                             "least height of a pitch's peak, 1 being a periodic sound; 0: any, as ODAS"),
  };
  return fields;
}

}  // namespace odas
