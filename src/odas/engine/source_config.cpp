// SPDX-License-Identifier: MIT
// The keys of section `raw`.
#include "odas/engine/config.hpp"

namespace odas {

Schema InterfaceConfig::schema() {
  using C = InterfaceConfig;
  static const std::vector<Field> fields{
      field<&C::type>("type", "", kAny, "kind of source; blackhole: none, a recording is given with odas run",
                      {"blackhole", "file", "stdin", "socket", "socket_listen", "soundcard", "soundcard_name",
                       "pulseaudio"}),
      field<&C::path>("path", "", kAny, "file: its path"),
      field<&C::paced>("paced", "", kAny, "file: as fast as it was recorded, not as fast as it can be read"),
      field<&C::ip>("ip", "", kAny,
                    "socket: address or name of the peer; socket_listen: where to listen; absent: 127.0.0.1"),
      field<&C::port>("port", "", {0, 65535}, "sockets: TCP port"),
      field<&C::token>("token", "", kAny,
                       "socket_listen: what a sender must say first; required beyond this machine"),
      field<&C::reconnect>("reconnect", "", kAny,
                           "sockets: a peer that closes is waited for; false: that is the end of the input"),
      field<&C::card>("card", "", kNotNegative, "soundcard: ALSA card number"),
      field<&C::device>("device", "", kNotNegative, "soundcard: ALSA device number"),
      field<&C::devicename>("devicename", "", kAny, "soundcard_name: ALSA PCM name; odas devices lists them"),
      field<&C::source>("source", "", kAny, "pulseaudio: name of the source; odas devices lists them"),
      field<&C::channelmap>(
          "channelmap", "", kAny,
          "pulseaudio: one position name per channel; absent: channels as they are numbered"),
  };
  return fields;
}

Schema InterfaceConfig::record_schema() {
  using C = InterfaceConfig;
  static const std::vector<Field> fields{
      field<&C::type>("type", "", kAny, "blackhole: they are not kept", {"blackhole", "file"}),
      field<&C::path>("path", "", kAny, "file: its path; WAV if it ends in .wav, else headerless"),
  };
  return fields;
}

Schema RecordConfig::schema() {
  static const std::vector<Field> fields = [] {
    Field place = field<&RecordConfig::interface>("interface", "", kAny, "where a copy of all channels goes");
    place.access_ = [](void* object) -> FieldValue {
      return GroupRef{&static_cast<RecordConfig*>(object)->interface, InterfaceConfig::record_schema()};
    };
    return std::vector<Field>{place};
  }();
  return fields;
}

Schema RawConfig::schema() {
  using C = RawConfig;
  static const std::vector<Field> fields{
      field<&C::fs>("fS", "Hz", {1000, 384000}, "sample rate of the microphones").must(),
      field<&C::hop_size>("hopSize", "samples", {1, 65536}, "block read at once")
          .defaults_to("general.size.hopSize"),
      field<&C::n_bits>("nBits", "bits", {8, 32}, "8, 16, 24 or 32: signed, little-endian, packed"),
      field<&C::format>("format", "", kAny,
                        "samples of the source, in place of nBits; auto: the best that the device offers; "
                        "S24_LE: in 4 bytes",
                        {"", "auto", "S8", "U8", "S16_LE", "S24_LE", "S24_3LE", "S32_LE", "FLOAT_LE"}),
      field<&C::n_channels>("nChannels", "", {1, 1024}, "channels of the stream").must(),
      field<&C::interface>("interface", "", kAny, "where the microphones are"),
      field<&C::record>("record", "", kAny, "keeps the microphones as they come, while it runs"),
  };
  return fields;
}

}  // namespace odas
