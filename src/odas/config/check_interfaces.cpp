// SPDX-License-Identifier: MIT
#include <filesystem>
#include <map>

#include "odas/base/host.hpp"
#include "odas/config/checks.hpp"

namespace odas {

namespace {

constexpr std::size_t kLongestDatagram = 65507;  // IPv4

/// What the kind of an interface needs. Whether the rest can be looked at.
bool check_interface(const std::string& path, const InterfaceConfig& interface, CheckReport& report) {
  if (!report.sound(path + ".type")) return false;
  const std::string& type = interface.type;
  const auto needs = [&](const char* key, bool there) {
    if (!there && report.sound(path + "." + key)) {
      report.error(path + "." + key, "is missing; type = \"" + type + "\" needs it");
    }
  };
  if (type == "file" || type == "voices") needs("path", !interface.path.empty());
  if (type == "socket" || type == "udp") {
    needs("ip", !interface.ip.empty());
    if (interface.ip.starts_with('<')) {
      report.warning(path + ".ip", "is \"" + interface.ip + "\": put the address of the peer here");
    }
  }
  if (type == "socket" || type == "udp" || type == "socket_listen") needs("port", interface.port != 0);
  // Beyond this machine a listener hears everybody: then the token tells friends from others.
  if (type == "socket_listen" && !is_loopback_host(interface.ip) && interface.token.empty()) {
    report.error(path + ".token", "is missing; whoever listens at " + interface.ip +
                                      ", beyond this machine, needs a token that clients say first");
  }
  if (type == "soundcard_name") needs("devicename", !interface.devicename.empty());
  if (type == "pulseaudio") needs("source", !interface.source.empty());
  return true;
}

void check_source(const Configuration& config, CheckReport& report) {
  const InterfaceConfig& interface = config.raw.interface;
  check_interface("raw.record.interface", config.raw.record.interface, report);
  if (!check_interface("raw.interface", interface, report)) return;
  const std::size_t names = interface.channelmap.size();
  if (interface.type == "pulseaudio" && names > 0 && report.sound("raw.nChannels") &&
      report.sound("raw.interface.channelmap") && names != static_cast<std::size_t>(config.raw.n_channels)) {
    report.error("raw.interface.channelmap", "has " + std::to_string(names) +
                                                 " names, but raw.nChannels is " +
                                                 std::to_string(config.raw.n_channels));
  }
}

void check_text(const std::string& path, const TextOutputConfig& output, bool binary, CheckReport& report) {
  const std::string formats =
      binary ? R"(must be "json", "jsonl" or "binary")" : R"(must be "json" or "jsonl")";
  for (const Place& place : places_of(path, output)) {
    const bool is_readable = check_interface(place.path, *place.interface, report);
    // Its own format, where it has one; else that of the stream is at fault.
    const std::string key = (place.interface->format.empty() ? path : place.path) + ".format";
    const std::string& type = place.interface->type;
    if (!is_readable || !report.sound(key) || type == "blackhole") continue;
    if (place.format == "undefined") {
      report.error(key, (report.written(key) ? "is \"undefined\"" : "is missing") +
                            (", but the interface is a " + type) + "; " + formats);
    } else if (place.format == "binary" && !binary) {
      report.error(key, "is \"binary\", which only ssl.potential can be; " + formats);
    } else if (place.format == "binary" && type == "terminal") {
      report.error(
          key, R"(is "binary", which a terminal cannot show; must be "json" or "jsonl", or type = "stdout")");
    }
  }
}

void check_audio(const std::string& path, const AudioOutputConfig& output, std::size_t slots,
                 CheckReport& report) {
  for (const Place& place : places_of(path, output)) {
    if (!check_interface(place.path, *place.interface, report)) continue;
    const std::string& type = place.interface->type;
    if (type == "terminal") {
      report.error(place.path + ".type", R"(is "terminal", which cannot show sound; "stdout" writes it out)");
    }
    const std::size_t block =
        slots * static_cast<std::size_t>(output.hop_size) * static_cast<std::size_t>(output.n_bits) / 8;
    if (type == "udp" && block > kLongestDatagram && report.sound(path)) {
      report.error(path + ".hopSize", "makes blocks of " + std::to_string(block) +
                                          " bytes; a datagram holds " + std::to_string(kLongestDatagram));
    }
  }
}

/// All places of all outputs.
std::vector<Place> outputs_of(const Configuration& config) {
  std::vector<Place> all;
  const auto add = [&](const char* path, const auto& output) {
    for (Place& place : places_of(path, output)) all.push_back(std::move(place));
  };
  add("ssl.potential", config.potential);
  add("sst.tracked", config.tracked);
  add("sss.separated", config.separated);
  add("sss.postfiltered", config.postfiltered);
  add("classify.category", config.category);
  return all;
}

/// Two writers of one file, one port or one standard output would spoil it.
void check_paths(const Configuration& config, CheckReport& report) {
  std::map<std::string, std::string> owners;
  const auto own = [&](const Place& place, const std::string& what, const char* key,
                       const std::string& value) {
    const auto [owner, fresh] = owners.emplace(what + value, place.path);
    if (!fresh) {
      report.error(place.path + key,
                   "is \"" + value + "\", the " + what + " of " + owner->second + " already");
    }
  };
  std::vector<Place> places{{"raw.interface", &config.raw.interface, ""},
                            {"raw.record.interface", &config.raw.record.interface, ""},
                            {"sst.control.interface", &config.control.interface, ""}};
  for (Place& place : outputs_of(config)) places.push_back(std::move(place));
  for (const Place& place : places) {
    const InterfaceConfig& to = *place.interface;
    const bool is_device = to.path.starts_with("/dev/");
    if ((to.type == "file" || to.type == "voices") && !to.path.empty() && !is_device) {
      own(place, to.type == "file" ? "file" : "folder", ".path",
          std::filesystem::path(to.path).lexically_normal().string());
    }
    if (to.type == "socket_listen" && to.port != 0) own(place, "port", ".port", std::to_string(to.port));
  }
}

/// Streams of bytes on standard output cannot share it; lines of text can, as in ODAS.
void check_standard_output(const Configuration& config, CheckReport& report) {
  std::string owner;
  for (const Place& place : outputs_of(config)) {
    if (place.interface->type != "stdout") continue;
    if (!owner.empty()) {
      report.error(place.path + ".type", "is \"stdout\", where " + owner + " goes already");
    }
    owner = place.path;
  }
  for (const Place& place : outputs_of(config)) {
    if (place.interface->type == "terminal" && !owner.empty()) {
      report.error(place.path + ".type",
                   "is \"terminal\", which is standard output, where " + owner + " goes already");
    }
  }
}

}  // namespace

void check_interfaces(const Configuration& config, CheckReport& report) {
  check_source(config, report);
  check_text("ssl.potential", config.potential, true, report);
  check_text("sst.tracked", config.tracked, false, report);
  check_text("classify.category", config.category, false, report);
  const std::size_t slots = config.pipeline.sst.slots();
  check_audio("sss.separated", config.separated, slots, report);
  check_audio("sss.postfiltered", config.postfiltered, slots, report);
  check_interface("sst.control.interface", config.control.interface, report);
  check_paths(config, report);
  check_standard_output(config, report);
}

}  // namespace odas
