// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <map>

#include "odas/base/host.hpp"
#include "odas/config/checks.hpp"

namespace odas {

namespace {

/// What the kind of an interface needs. Whether the rest can be looked at.
bool check_interface(const std::string& path, const InterfaceConfig& interface, CheckReport& report) {
  if (!report.sound(path + ".type")) return false;
  const std::string& type = interface.type;
  const auto needs = [&](const char* key, bool there) {
    if (!there && report.sound(path + "." + key)) {
      report.error(path + "." + key, "is missing; type = \"" + type + "\" needs it");
    }
  };
  if (type == "file") needs("path", !interface.path.empty());
  if (type == "socket") {
    needs("ip", !interface.ip.empty());
    needs("port", interface.port != 0);
    if (interface.ip.starts_with('<')) {
      report.warning(path + ".ip", "is \"" + interface.ip + "\": put the address of the peer here");
    }
  }
  if (type == "soundcard_name") needs("devicename", !interface.devicename.empty());
  if (type == "pulseaudio") needs("source", !interface.source.empty());
  return true;
}

/// Beyond this machine a listener hears everybody: then the token tells friends from others.
void check_listener(const std::string& path, const InterfaceConfig& interface, CheckReport& report) {
  if (interface.type != "socket_listen") return;
  if (interface.port == 0 && report.sound(path + ".port")) {
    report.error(path + ".port", "is missing; type = \"socket_listen\" needs it");
  }
  if (!is_loopback_host(interface.ip) && interface.token.empty() && report.sound(path + ".token")) {
    report.error(path + ".token", "is missing; whoever listens at " + interface.ip +
                                      ", beyond this machine, needs a token that clients say first");
  }
}

void check_source(const Configuration& config, CheckReport& report) {
  const InterfaceConfig& interface = config.raw.interface;
  check_interface("raw.record.interface", config.raw.record.interface, report);
  if (!check_interface("raw.interface", interface, report)) return;
  check_listener("raw.interface", interface, report);
  const std::size_t names = interface.channelmap.size();
  if (interface.type == "pulseaudio" && names > 0 && report.sound("raw.nChannels") &&
      report.sound("raw.interface.channelmap") && names != static_cast<std::size_t>(config.raw.n_channels)) {
    report.error("raw.interface.channelmap", "has " + std::to_string(names) +
                                                 " names, but raw.nChannels is " +
                                                 std::to_string(config.raw.n_channels));
  }
}

void check_text(const std::string& path, const TextOutputConfig& output, bool binary, CheckReport& report) {
  if (!check_interface(path + ".interface", output.interface, report)) return;
  if (!report.sound(path + ".format") || output.interface.type == "blackhole") return;
  const std::string text_formats = "must be \"json\" or \"jsonl\"";
  if (output.format == "undefined") {
    report.error(path + ".format", (report.written(path + ".format") ? "is \"undefined\"" : "is missing") +
                                       (", but the interface is a " + output.interface.type) + "; " +
                                       text_formats +
                                       (binary && output.interface.type == "file" ? " or \"binary\"" : ""));
  } else if (output.format == "binary" && !binary) {
    report.error(path + ".format", "is \"binary\", which only ssl.potential can be; " + text_formats);
  } else if (output.format == "binary" && output.interface.type != "file") {
    report.error(path + ".format", "is \"binary\", which only a file can be; " + text_formats);
  }
}

void check_audio(const std::string& path, const InterfaceConfig& interface, CheckReport& report) {
  if (check_interface(path, interface, report) && interface.type == "terminal") {
    report.error(path + ".type",
                 "is \"terminal\", which cannot show sound; must be \"blackhole\", \"file\" or \"socket\"");
  }
}

/// Two writers of one file would spoil it.
void check_paths(const Configuration& config, CheckReport& report) {
  const std::array<std::pair<const char*, const InterfaceConfig*>, 7> all{{
      {"raw.interface", &config.raw.interface},
      {"raw.record.interface", &config.raw.record.interface},
      {"ssl.potential.interface", &config.potential.interface},
      {"sst.tracked.interface", &config.tracked.interface},
      {"sss.separated.interface", &config.separated.interface},
      {"sss.postfiltered.interface", &config.postfiltered.interface},
      {"classify.category.interface", &config.category.interface},
  }};
  std::map<std::string, std::string> owners;
  for (const auto& [path, interface] : all) {
    if (interface->type != "file" || interface->path.empty() || interface->path.starts_with("/dev/"))
      continue;
    const std::string file = std::filesystem::path(interface->path).lexically_normal().string();
    const auto [owner, fresh] = owners.emplace(file, path);
    if (!fresh) {
      report.error(std::string(path) + ".path",
                   "is \"" + interface->path + "\", the file of " + owner->second + " already");
    }
  }
}

}  // namespace

void check_interfaces(const Configuration& config, CheckReport& report) {
  check_source(config, report);
  check_text("ssl.potential", config.potential, true, report);
  check_text("sst.tracked", config.tracked, false, report);
  check_text("classify.category", config.category, false, report);
  check_audio("sss.separated.interface", config.separated.interface, report);
  check_audio("sss.postfiltered.interface", config.postfiltered.interface, report);
  if (check_interface("sst.control.interface", config.control.interface, report)) {
    check_listener("sst.control.interface", config.control.interface, report);
  }
  check_paths(config, report);
}

}  // namespace odas
