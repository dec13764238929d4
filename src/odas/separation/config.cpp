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

Schema AdaptiveConfig::schema() {
  using C = AdaptiveConfig;
  static const std::vector<Field> fields{
      field<&C::memory>("memory", "s", {0.01, 3600},
                        "time constant of what is learned, of the time it is heard"),
      field<&C::loading>("loading", "", kPositive, "diagonal loading, of the power of all but the talker"),
      field<&C::unexplained>(
          "unexplained", "", kNotNegative,
          "diagonal loading, of the power of the talker: more harms one in quiet less, and "
          "lets more of the others pass"),
      field<&C::tradeoff>("tradeoff", "", kNotNegative,
                          "weight of the Wiener share: 0 takes out what the array can, more also bins where "
                          "the talker is weak (dmvdr alone)"),
      field<&C::harm>("harm", "", kPositive,
                      "ratio of powers, talker to all else, at which half of the reference microphone is let "
                      "through as it is"),
      field<&C::white_noise_gain>("whiteNoiseGain", "dB", {-60, 30},
                                  "loading grows where the white noise gain falls under this"),
  };
  return fields;
}

Schema MaskFilterConfig::schema() {
  using C = MaskFilterConfig;
  static const std::vector<Field> fields{
      field<&C::g_min>("Gmin", "", kUnit, "smallest gain"),
      field<&C::leak>(
          "leak", "", kUnit,
          "how much of another voice is thought to be left in a beam before it has been heard, as power"),
  };
  return fields;
}

Schema SssConfig::schema() {
  static const std::vector<Field> fields{
      field<&SssConfig::mode_sep>("mode_sep", "", kAny, "beamformer", {"dds", "dgss", "dmvdr", "dgev"}),
      field<&SssConfig::mode_pf>("mode_pf", "", kAny, "post-filter", {"ms", "ss", "mask"}),
      field<&SssConfig::frame_size>("frameSize", "samples", {0, 65536},
                                    "analysis frame of separation alone: a longer one separates better and "
                                    "delays voices by as much; the hop is common")
          .defaults_to("general.size.frameSize"),
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
      field<&SssConfig::dmvdr>("dmvdr", "", kAny, "minimum variance distortionless response"),
      field<&SssConfig::dgev>("dgev", "", kAny, "generalized eigenvalue beamformer"),
      field<&SssConfig::ms>("ms", "", kAny, "the multi-source post-filter"),
      field<&SssConfig::ss>("ss", "", kAny, "the single-source post-filter"),
      field<&SssConfig::mask>("mask", "", kAny, "the post-filter by masks"),
  };
  return fields;
}

}  // namespace odas
