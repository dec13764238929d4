// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "odas/io/alsa_pcm.hpp"
#include "odas/io/capture_devices.hpp"

namespace odas {

/// A PCM by name: what it offers, without starting it, or why it cannot be asked.
[[nodiscard]] CaptureDevice ask_alsa_device(const std::string& name, const AlsaOpener& open = open_alsa);

/// The sound cards, by names that a reboot does not change, and the PCMs of ALSA's configuration that show
/// themselves and are no mere converters. `fault`: why cards that are there cannot be used; "" if they can.
[[nodiscard]] std::vector<CaptureDevice> list_alsa_devices(std::string& fault);

/// What to say of a PCM that cannot be opened, behind ALSA's own word for it.
[[nodiscard]] std::string alsa_advice(int error, const std::string& name, const std::string& owner);

}  // namespace odas
