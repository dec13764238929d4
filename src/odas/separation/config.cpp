// SPDX-License-Identifier: MIT
#include "odas/separation/config.hpp"

namespace odas {

Schema GssConfig::schema() {
  static const std::vector<Field> fields{
      field<&GssConfig::mu>("mu", "", kNotNegative, "adaptation step"),
      field<&GssConfig::lambda>("lambda", "", kNotNegative, "leakage"),
  };
  return fields;
}

Schema MultiSourceFilterConfig::schema() {
  using C = MultiSourceFilterConfig;
  static const std::vector<Field> fields{
      field<&C::alpha_p_min>("alphaPmin", "", kUnit, "floor of the decision-directed weight"),
      field<&C::eta>("eta", "", kNotNegative, "leakage between separated sources"),
      field<&C::alpha_z>("alphaZ", "", kUnit, "weight of the new value in the smoothed powers"),
      field<&C::theta_win>("thetaWin", "", kPositive, "threshold of the speech presence"),
      field<&C::alpha_win>("alphaWin", "", kUnit, "weight of the new value in the speech presence"),
      field<&C::max_absence_prob>("maxAbsenceProb", "", kUnit, "largest probability that speech is absent"),
      field<&C::g_min>("Gmin", "", {0, 1, true}, "smallest gain"),
      field<&C::win_size_local>("winSizeLocal", "bins", {1, 65536},
                                "local smoothing window; at most the frame"),
      field<&C::win_size_global>("winSizeGlobal", "bins", {1, 65536},
                                 "global smoothing window; at most the frame"),
      field<&C::win_size_frame>("winSizeFrame", "bins", {1, 65536},
                                "frame smoothing window; at most the frame")
          .defaults_to("general.size.frameSize"),
  };
  return fields;
}

Schema SingleSourceFilterConfig::schema() {
  using C = SingleSourceFilterConfig;
  static const std::vector<Field> fields{
      field<&C::g_min>("Gmin", "", kUnit, "smallest gain"),
      field<&C::g_mid>("Gmid", "", kAny, "ratio at which the gain is half way"),
      field<&C::g_slope>("Gslope", "", kNotNegative, "steepness of the gain"),
  };
  return fields;
}

Schema SssConfig::schema() {
  static const std::vector<Field> fields{
      field<&SssConfig::mode_sep>("mode_sep", "", kAny, "beamformer", {"dds", "dgss", "dmvdr"}),
      field<&SssConfig::mode_pf>("mode_pf", "", kAny, "post-filter", {"ms", "ss"}),
      field<&SssConfig::noise>(
          "noise", "", kAny,
          "file with the machine's own noise, made by odas learn-noise; relative to this "
          "configuration; absent: none is known, as ODAS"),
      field<&SssConfig::lookback>("lookback", "ms", {0, 5000},
                                  "how long before its track was found a voice's audio begins; all "
                                  "separated audio comes later by as much; 0: none, as ODAS"),
      field<&SssConfig::gain_sep>("gain_sep", "", kAny, "gain of the separated streams, linear"),
      field<&SssConfig::gain_pf>("gain_pf", "", kAny, "gain of the post-filtered streams, linear"),
      ignored_field("dds", "delay-and-sum has no settings"),
      field<&SssConfig::dgss>("dgss", "", kAny, "geometric source separation"),
      ignored_field("dmvdr", "no settings yet"),
      field<&SssConfig::ms>("ms", "", kAny, "the multi-source post-filter"),
      field<&SssConfig::ss>("ss", "", kAny, "the single-source post-filter"),
  };
  return fields;
}

}  // namespace odas
