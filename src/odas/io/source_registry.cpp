// SPDX-License-Identifier: MIT
// The sources: the half of the registry that listens.
#include <algorithm>
#include <array>
#include <string_view>

#include "odas/base/error.hpp"
#include "odas/io/alsa_source.hpp"
#include "odas/io/kept_source.hpp"
#include "odas/io/paced_source.hpp"
#include "odas/io/pulse_source.hpp"
#include "odas/io/recording.hpp"
#include "odas/io/registry.hpp"
#include "odas/io/stream_source.hpp"

namespace odas {
namespace {

using Made = std::unique_ptr<AudioSource>;

Made stream_from(const RawConfig& raw, std::unique_ptr<StreamPort> port) {
  return std::make_unique<StreamSource>(raw, std::move(port));
}

Made open_file(const RawConfig& raw) {
  Made recording = open_recording(raw.interface.path, raw);
  if (!raw.interface.paced) return recording;
  return std::make_unique<PacedSource>(std::move(recording));
}

// One line a kind of source. No function: it is known, but was left out when this program was built.
struct SourceKind {
  std::string_view type;
  Made (*make)(const RawConfig&);
};
constexpr std::array kSources {
  SourceKind{"file", open_file},
      SourceKind{"stdin",
                 [](const RawConfig& raw) { return stream_from(raw, std::make_unique<StdinPort>()); }},
      SourceKind{"socket",
                 [](const RawConfig& raw) {
                   return stream_from(raw, std::make_unique<DialPort>(raw.interface.ip, raw.interface.port));
                 }},
      SourceKind{"socket_listen",
                 [](const RawConfig& raw) {
                   const InterfaceConfig& at = raw.interface;
                   return stream_from(raw, std::make_unique<ListenPort>(at.ip, at.port, at.token));
                 }},
#if defined(ODAS_WITH_ALSA)
      SourceKind{"soundcard",
                 [](const RawConfig& raw) -> Made {
                   const InterfaceConfig& at = raw.interface;
                   const std::string card = "hw:" + std::to_string(at.card) + "," + std::to_string(at.device);
                   return std::make_unique<AlsaSource>(card, raw);
                 }},
      SourceKind{"soundcard_name",
                 [](const RawConfig& raw) -> Made {
                   return std::make_unique<AlsaSource>(raw.interface.devicename, raw);
                 }},
#else
      SourceKind{"soundcard", nullptr}, SourceKind{"soundcard_name", nullptr},
#endif
#if defined(ODAS_WITH_PULSE)
      SourceKind{"pulseaudio",
                 [](const RawConfig& raw) -> Made { return std::make_unique<PulseSource>(raw); }},
#else
      SourceKind{"pulseaudio", nullptr},
#endif
};

}  // namespace

std::unique_ptr<AudioSource> make_source(const RawConfig& raw) {
  const std::string& type = raw.interface.type;
  if (type == "blackhole") {
    throw ConfigError(
        "raw.interface.type",
        "is \"blackhole\": there is nothing to listen to; set the interface of the microphones, "
        "or give a recording to odas run");
  }
  const auto* kind =
      std::find_if(kSources.begin(), kSources.end(), [&](const SourceKind& k) { return k.type == type; });
  if (kind == kSources.end() || kind->make == nullptr) {
    throw ConfigError("raw.interface.type", "is \"" + type +
                                                "\", which was left out when this program was built; "
                                                "build it again with -DODAS_WITH_" +
                                                std::string(type == "pulseaudio" ? "PULSE" : "ALSA") + "=ON");
  }
  return keep_source(kind->make(raw), raw);
}

}  // namespace odas
