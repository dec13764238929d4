// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "odas/base/field.hpp"
#include "odas/engine/studio_config.hpp"
#include "odas/pipeline/config.hpp"

namespace odas {

/// Where bytes come from or go to: any `interface` group.
struct InterfaceConfig {
  std::string type = "blackhole";
  std::string path;                     // file
  std::string ip;                       // sockets
  int port = 0;                         // sockets
  std::string token;                    // socket_listen
  std::string format;                   // one of several places for text: its own format
  int card = 0, device = 0;             // soundcard: ALSA hw:card,device
  std::string devicename;               // soundcard_name: ALSA PCM name
  std::string source;                   // pulseaudio
  std::vector<std::string> channelmap;  // pulseaudio
  bool paced = false;                   // file, as source: as fast as it was recorded
  bool reconnect = false;               // sockets, as source: a peer that closes is waited for
  static Schema schema();               // of a source
  static Schema record_schema();
  static Schema text_schema();   // of a sink of text
  static Schema audio_schema();  // of a sink of audio
  static Schema control_schema();
};

/// A copy of the microphones as they come: `raw.record`.
struct RecordConfig {
  InterfaceConfig interface;
  static Schema schema();
};

/// The microphones as they come: section `raw`.
struct RawConfig {
  int fs = 16000;
  int hop_size = 128;
  int n_bits = 16;
  std::string format;  // "": as n_bits says
  int n_channels = 0;
  InterfaceConfig interface;
  RecordConfig record;
  static Schema schema();
};

/// Which input channel is which microphone: section `mapping`.
struct MappingConfig {
  std::vector<int> map;        // 1-based; 0: silence; empty: 1, 2, 3, ...
  std::vector<int> reference;  // 1-based: what the machine plays; empty: unknown
  float echo_length = 300;     // ms
  static Schema schema();
};

/// One more place that a stream goes to; text may have another format there.
struct TextPlaceConfig : InterfaceConfig {
  static Schema schema();
};
struct AudioPlaceConfig : InterfaceConfig {
  static Schema schema();
};

/// A stream of text or numbers: `ssl.potential`, `sst.tracked`, `classify.category`.
struct TextOutputConfig {
  std::string format = "undefined";
  InterfaceConfig interface;
  std::vector<TextPlaceConfig> interfaces;
  static Schema schema();
};

/// A stream of audio: `sss.separated`, `sss.postfiltered`.
struct AudioOutputConfig {
  int fs = 16000;
  int hop_size = 128;
  int n_bits = 16;
  InterfaceConfig interface;
  std::vector<AudioPlaceConfig> interfaces;
  static Schema schema();
};

/// Whence targets come and go while it runs: `sst.control`.
struct ControlConfig {
  InterfaceConfig interface;
  static Schema schema();
};

/// A whole configuration file.
struct Configuration {
  RawConfig raw;
  MappingConfig mapping;
  PipelineConfig pipeline;
  TextOutputConfig potential;
  TextOutputConfig tracked;
  TextOutputConfig category;
  ControlConfig control;
  AudioOutputConfig separated;
  AudioOutputConfig postfiltered;
  StudioConfig studio;
};

/// Where a stream goes: one of its interfaces, blackholes too.
struct Place {
  std::string path;  // "sst.tracked.interfaces[1]"
  const InterfaceConfig* interface = nullptr;
  std::string format;  // of text
};
[[nodiscard]] std::vector<Place> places_of(const std::string& path, const TextOutputConfig& output);
[[nodiscard]] std::vector<Place> places_of(const std::string& path, const AudioOutputConfig& output);

/// Whether somebody listens.
template <class Output>
[[nodiscard]] bool is_wanted(const Output& output) {
  for (const Place& place : places_of("", output)) {
    if (place.interface->type != "blackhole") return true;
  }
  return false;
}

/// One section of the file, and the structs that its keys belong to.
struct Section {
  std::string_view name;
  std::vector<GroupRef> groups;
};
[[nodiscard]] std::vector<Section> sections_of(Configuration& config);

}  // namespace odas
