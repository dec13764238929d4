// SPDX-License-Identifier: MIT
// The sources: the half of the registry that listens.
#include <algorithm>
#include <array>
#include <string_view>

#include "odas/base/error.hpp"
#include "odas/io/recording.hpp"
#include "odas/io/registry.hpp"

namespace odas {
namespace {

// One line a kind of source. No function: it is known, and comes later.
struct SourceKind {
  std::string_view type;
  std::unique_ptr<AudioSource> (*make)(const RawConfig&);
};
constexpr std::array kSources{
    SourceKind{"file", [](const RawConfig& raw) { return open_recording(raw.interface.path, raw); }},
    SourceKind{"socket", nullptr},
    SourceKind{"soundcard", nullptr},
    SourceKind{"soundcard_name", nullptr},
    SourceKind{"pulseaudio", nullptr},
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
    throw ConfigError("raw.interface.type",
                      "is \"" + type + "\", which this version cannot do yet; use \"file\"");
  }
  return kind->make(raw);
}

}  // namespace odas
