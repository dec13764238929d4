// SPDX-License-Identifier: MIT
#include "odas/io/capture_devices.hpp"

#include <nlohmann/json.hpp>

namespace odas {
namespace {

std::string indented(const std::string& text, const std::string& by) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    all += by + text.substr(at, end - at) + '\n';
    at = end + 1;
  }
  return all;
}

std::string describe(const CaptureDevice& device) {
  std::string text = device.name + "\n";
  if (!device.description.empty()) text += indented(device.description, "    ");
  if (!device.problem.empty()) return text + indented(device.problem, "    ");
  const CaptureOffer& offer = device.offer;
  text += "    channels " + channels_text(offer) + "; " + rates_text(offer) + " Hz; " + formats_text(offer) +
          "\n";
  if (device.monitor) return text + "    plays what a loudspeaker plays: it is no microphone\n";
  return text + indented(propose_raw(offer, interface_text(device)), "        ");
}

}  // namespace

std::string interface_text(const CaptureDevice& device) {
  return device.system == "PulseAudio" ? "type = \"pulseaudio\"; source = \"" + device.name + "\";"
                                       : "type = \"soundcard_name\"; devicename = \"" + device.name + "\";";
}

std::string describe_devices(std::span<const CaptureDevice> devices) {
  std::string text;
  std::string system;
  for (const CaptureDevice& device : devices) {
    if (device.system != system) text += (text.empty() ? "" : "\n") + device.system + "\n";
    system = device.system;
    text += indented(describe(device), "  ");
  }
  return text;
}

std::string devices_json(std::span<const CaptureDevice> devices) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const CaptureDevice& device : devices) {
    nlohmann::ordered_json one;
    one["system"] = device.system;
    one["name"] = device.name;
    one["description"] = device.description;
    one["microphone"] = !device.monitor;
    if (!device.problem.empty()) {
      one["problem"] = device.problem;
    } else {
      const CaptureOffer& offer = device.offer;
      one["channels"] = {{"min", offer.min_channels}, {"max", offer.max_channels}, {"asked", offer.channels}};
      one["rate"] = {{"min", offer.min_rate}, {"max", offer.max_rate}, {"usual", offer.rates}};
      one["formats"] = nlohmann::ordered_json::array();
      for (const SampleFormat format : offer.formats) one["formats"].push_back(name_of(format));
      one["other_formats"] = offer.other_formats;
      one["raw"] = propose_raw(offer, interface_text(device));
    }
    all.push_back(std::move(one));
  }
  // A device may have any bytes for its name.
  return all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace odas
