// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "odas/io/capture_devices.hpp"

namespace odas {

struct DeviceList {
  std::vector<CaptureDevice> devices;
  std::vector<std::string> notes;  // what a user should know: why there is none, or not all of them
};

/// All that can be captured from on this machine, by ALSA and PulseAudio, as far as this program has them.
[[nodiscard]] DeviceList list_devices();

/// One PCM of ALSA by its name, also one that no list shows.
[[nodiscard]] CaptureDevice ask_device(const std::string& name);

}  // namespace odas
