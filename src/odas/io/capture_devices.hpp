// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "odas/io/capture_offer.hpp"

namespace odas {

/// Something on this machine that microphones can be heard through.
struct CaptureDevice {
  std::string system;       // "ALSA", "PulseAudio"
  std::string name;         // in raw.interface: a reboot does not change it
  std::string description;  // for people
  std::string problem;      // why it could not be asked what it offers; "" if it could
  CaptureOffer offer;
  bool monitor = false;  // what a loudspeaker plays
};

/// The keys of `raw.interface` for it.
[[nodiscard]] std::string interface_text(const CaptureDevice& device);

/// For people: each with what it offers and the section `raw` that suits it.
[[nodiscard]] std::string describe_devices(std::span<const CaptureDevice> devices);

/// For programs: a JSON array.
[[nodiscard]] std::string devices_json(std::span<const CaptureDevice> devices);

}  // namespace odas
