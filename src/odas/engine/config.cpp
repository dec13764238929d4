// SPDX-License-Identifier: MIT
#include "odas/engine/config.hpp"

namespace odas {

namespace {

/// The keys of a place that bytes go to.
std::vector<Field> sink_fields(std::vector<std::string_view> types) {
  using C = InterfaceConfig;
  return {
      field<&C::type>("type", "", kAny, "kind of sink; blackhole: nobody listens, so it is not computed",
                      std::move(types)),
      field<&C::path>("path", "", kAny, "file: its path; voices: a folder"),
      field<&C::ip>(
          "ip", "", kAny,
          "socket, udp: address or name of the peer; socket_listen: where to listen, absent: 127.0.0.1"),
      field<&C::port>("port", "", {0, 65535}, "socket, socket_listen: TCP port; udp: UDP port"),
      field<&C::token>("token", "", kAny,
                       "socket_listen: what clients must say first; required beyond this machine"),
  };
}

}  // namespace

Schema InterfaceConfig::text_schema() {
  static const std::vector<Field> fields =
      sink_fields({"blackhole", "file", "socket", "socket_listen", "udp", "terminal", "stdout"});
  return fields;
}

Schema InterfaceConfig::audio_schema() {
  static const std::vector<Field> fields =
      sink_fields({"blackhole", "file", "voices", "socket", "socket_listen", "udp", "terminal", "stdout"});
  return fields;
}

Schema TextPlaceConfig::schema() {
  static const std::vector<Field> fields = [] {
    const Schema common = text_schema();
    std::vector<Field> all(common.begin(), common.end());
    all.push_back(field<&InterfaceConfig::format>("format", "", kAny, "absent: that of the stream",
                                                  {"", "json", "jsonl", "binary"}));
    return all;
  }();
  return fields;
}

Schema AudioPlaceConfig::schema() { return audio_schema(); }

Schema InterfaceConfig::control_schema() {
  using C = InterfaceConfig;
  static const std::vector<Field> fields{
      field<&C::type>("type", "", kAny,
                      "socket_listen: clients come to us; socket: we dial one; blackhole: none",
                      {"blackhole", "socket", "socket_listen"}),
      field<&C::ip>("ip", "", kAny, "address or name, of the peer or to listen at; absent: 127.0.0.1"),
      field<&C::port>("port", "", {0, 65535}, "TCP port"),
      field<&C::token>("token", "", kAny,
                       "socket_listen: what clients must say first; required beyond this machine"),
  };
  return fields;
}

namespace {

/// The `interface` of a group that is no source: with the keys that it can have.
template <class Group, Schema (*schema)()>
Field interface_field(std::string_view meaning) {
  Field place = field<&Group::interface>("interface", "", kAny, meaning);
  place.access_ = [](void* object) -> FieldValue {
    return GroupRef{&static_cast<Group*>(object)->interface, schema()};
  };
  return place;
}

}  // namespace

Schema MappingConfig::schema() {
  static const std::vector<Field> fields{
      field<&MappingConfig::map>(
          "map", "", {0, 1024},
          "input channel of each microphone, from 1; 0 is silence; absent: 1, 2, 3, ..."),
      field<&MappingConfig::reference>(
          "reference", "", {1, 1024},
          "input channels, from 1, that carry what the machine itself plays; its "
          "echo is taken out of all microphones; absent: none, as ODAS"),
      field<&MappingConfig::echo_length>("echoLength", "ms", {1, 2000},
                                         "longest echo that is taken out: the delay of the playing and the "
                                         "first part of the room's reverberation"),
  };
  return fields;
}

Schema TextOutputConfig::schema() {
  using C = TextOutputConfig;
  static const std::vector<Field> fields{
      field<&C::format>("format", "", kAny, "json: ODAS's own; jsonl: one object a line; binary: four floats",
                        {"undefined", "json", "jsonl", "binary"}),
      interface_field<C, InterfaceConfig::text_schema>("where it goes"),
      field<&C::interfaces>("interfaces", "", kAny, "where else it goes: a list of any length"),
  };
  return fields;
}

Schema ControlConfig::schema() {
  static const std::vector<Field> fields{
      interface_field<ControlConfig, InterfaceConfig::control_schema>("where targets come from"),
  };
  return fields;
}

Schema AudioOutputConfig::schema() {
  using C = AudioOutputConfig;
  static const std::vector<Field> fields{
      field<&C::fs>("fS", "Hz", {1000, 384000}, "sample rate of the stream")
          .defaults_to("general.samplerate.mu"),
      field<&C::hop_size>("hopSize", "samples", {1, 65536}, "block written at once")
          .defaults_to("general.size.hopSize"),
      field<&C::n_bits>("nBits", "bits", {8, 32}, "8, 16, 24 or 32: signed, little-endian, packed"),
      ignored_field("gain", "never read by ODAS; see sss.gain_sep and sss.gain_pf"),
      interface_field<C, InterfaceConfig::audio_schema>("where it goes"),
      field<&C::interfaces>("interfaces", "", kAny, "where else it goes: a list of any length"),
  };
  return fields;
}

namespace {

struct PotentialGroup {
  static Schema schema() {
    static const std::vector<Field> fields{
        field<&Configuration::potential>("potential", "", kAny, "the directions found")};
    return fields;
  }
};
struct TrackedGroup {
  static Schema schema() {
    static const std::vector<Field> fields{
        field<&Configuration::tracked>("tracked", "", kAny, "the tracks"),
        field<&Configuration::control>("control", "", kAny, "targets that come, move and go while it runs")};
    return fields;
  }
};
struct AudioGroup {
  static Schema schema() {
    static const std::vector<Field> fields{
        field<&Configuration::separated>("separated", "", kAny, "the separated voices"),
        field<&Configuration::postfiltered>("postfiltered", "", kAny, "the post-filtered voices")};
    return fields;
  }
};
struct CategoryGroup {
  static Schema schema() {
    static const std::vector<Field> fields{
        field<&Configuration::category>("category", "", kAny, "speech or not")};
    return fields;
  }
};

}  // namespace

namespace {

template <class Output>
std::vector<Place> all_places(const std::string& path, const Output& output, const std::string& format) {
  std::vector<Place> places{{path + ".interface", &output.interface, format}};
  for (std::size_t i = 0; i < output.interfaces.size(); ++i) {
    const InterfaceConfig& one = output.interfaces[i];
    places.push_back(
        {path + ".interfaces[" + std::to_string(i) + "]", &one, one.format.empty() ? format : one.format});
  }
  return places;
}

}  // namespace

std::vector<Place> places_of(const std::string& path, const TextOutputConfig& output) {
  return all_places(path, output, output.format);
}
std::vector<Place> places_of(const std::string& path, const AudioOutputConfig& output) {
  return all_places(path, output, "");
}

std::vector<Section> sections_of(Configuration& c) {
  return {
      {"raw", {{&c.raw, RawConfig::schema()}}},
      {"mapping", {{&c.mapping, MappingConfig::schema()}}},
      {"general", {{&c.pipeline.general, GeneralConfig::schema()}}},
      {"sne", {{&c.pipeline.sne, McraConfig::schema()}}},
      {"ssl", {{&c.pipeline.ssl, SslConfig::schema()}, {&c, PotentialGroup::schema()}}},
      {"sst", {{&c.pipeline.sst, SstConfig::schema()}, {&c, TrackedGroup::schema()}}},
      {"sss", {{&c.pipeline.sss, SssConfig::schema()}, {&c, AudioGroup::schema()}}},
      {"classify", {{&c.pipeline.classify, ClassifyConfig::schema()}, {&c, CategoryGroup::schema()}}},
      {"studio", {{&c.studio, StudioConfig::schema()}}},
  };
}

}  // namespace odas
