// SPDX-License-Identifier: MIT
// The keys of section `raw`.
#include "odas/engine/config.hpp"

namespace odas {

Schema InterfaceConfig::schema() {
  using C = InterfaceConfig;
  static const std::vector<Field> fields{
      field<&C::type>("type", "", kAny, "kind of source; blackhole: none, a recording is given with odas run",
                      {"blackhole", "file", "socket", "soundcard", "soundcard_name", "pulseaudio"}),
      field<&C::path>("path", "", kAny, "file: its path"),
      field<&C::ip>("ip", "", kAny, "socket: address of the peer"),
      field<&C::port>("port", "", {0, 65535}, "socket: TCP port of the peer"),
      field<&C::card>("card", "", kNotNegative, "soundcard: ALSA card number"),
      field<&C::device>("device", "", kNotNegative, "soundcard: ALSA device number"),
      field<&C::devicename>("devicename", "", kAny, "soundcard_name: ALSA PCM name"),
      field<&C::source>("source", "", kAny, "pulseaudio: name of the source"),
      field<&C::channelmap>("channelmap", "", kAny, "pulseaudio: one position name per channel"),
  };
  return fields;
}

Schema RawConfig::schema() {
  using C = RawConfig;
  static const std::vector<Field> fields{
      field<&C::fs>("fS", "Hz", {1000, 384000}, "sample rate of the microphones").must(),
      field<&C::hop_size>("hopSize", "samples", {1, 65536}, "block read at once")
          .defaults_to("general.size.hopSize"),
      field<&C::n_bits>("nBits", "bits", {8, 32}, "8, 16, 24 or 32: signed, little-endian, packed"),
      field<&C::n_channels>("nChannels", "", {1, 1024}, "channels of the stream").must(),
      field<&C::interface>("interface", "", kAny, "where the microphones are"),
  };
  return fields;
}

}  // namespace odas
