// SPDX-License-Identifier: MIT
#include "odas/array/config.hpp"

namespace odas {

Schema MicConfig::schema() {
  static const std::vector<Field> fields{
      field<&MicConfig::mu>("mu", "m", kAny, "position (x, y, z) in the right-handed frame of the array")
          .must(),
      field<&MicConfig::sigma2>("sigma2", "m^2", kAny, "3x3 covariance of the position, row by row"),
      field<&MicConfig::direction>("direction", "", kAny, "where the microphone points; any length but zero"),
      field<&MicConfig::angle>(
          "angle", "degrees", {0, 180},
          "half-angles around the direction: all passes below the first, nothing above the second"),
  };
  return fields;
}

Schema SpatialFilterConfig::schema() {
  static const std::vector<Field> fields{
      field<&SpatialFilterConfig::direction>("direction", "", kAny,
                                             "axis of the region; any length but zero"),
      field<&SpatialFilterConfig::angle>(
          "angle", "degrees", {0, 180},
          "half-angles around the axis: all passes below the first, nothing above the second"),
  };
  return fields;
}

Schema SizeConfig::schema() {
  static const std::vector<Field> fields{
      field<&SizeConfig::hop_size>("hopSize", "samples", {1, 65536}, "advance from hop to hop"),
      field<&SizeConfig::frame_size>("frameSize", "samples", {2, 65536},
                                     "analysis window; at least the hop, even"),
  };
  return fields;
}

Schema SampleRateConfig::schema() {
  static const std::vector<Field> fields{
      field<&SampleRateConfig::mu>("mu", "Hz", {1000, 384000}, "processing rate; at most raw.fS"),
      ignored_field("sigma2", "uncertainty of the rate; without effect, as in ODAS"),
  };
  return fields;
}

Schema SpeedOfSoundConfig::schema() {
  static const std::vector<Field> fields{
      field<&SpeedOfSoundConfig::mu>("mu", "m/s", kPositive, "speed of sound"),
      field<&SpeedOfSoundConfig::sigma2>("sigma2", "(m/s)^2", kNotNegative,
                                         "its variance; widens the automatic delta of the scans"),
  };
  return fields;
}

Schema GeneralConfig::schema() {
  static const std::vector<Field> fields{
      field<&GeneralConfig::epsilon>("epsilon", "", kPositive, "what keeps divisions finite"),
      field<&GeneralConfig::size>("size", "", kAny, "hop and frame, common to all stages"),
      field<&GeneralConfig::samplerate>("samplerate", "", kAny, "processing rate"),
      field<&GeneralConfig::speedofsound>("speedofsound", "", kAny, "speed of sound"),
      field<&GeneralConfig::mics>("mics", "", kAny, "the microphones, in the order of mapping.map").must(),
      field<&GeneralConfig::spatialfilters>("spatialfilters", "", kAny,
                                            "regions listened to; () is the full sphere; absent: a half "
                                            "sphere if all microphones lie in a plane"),
      field<&GeneralConfig::n_thetas>("nThetas", "", {2, 100000},
                                      "points of the gain tables over 0..180 degrees"),
      field<&GeneralConfig::gain_min>("gainMin", "", kUnit,
                                      "a pair (SSL) or a microphone (SSS) with less gain is left out"),
  };
  return fields;
}

}  // namespace odas
