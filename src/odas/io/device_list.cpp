// SPDX-License-Identifier: MIT
#include "odas/io/device_list.hpp"

#if defined(ODAS_WITH_ALSA)
#include "odas/io/alsa_devices.hpp"
#endif
#if defined(ODAS_WITH_PULSE)
#include "odas/io/pulse_client.hpp"
#endif

namespace odas {
namespace {

void add_alsa(DeviceList& list) {
#if defined(ODAS_WITH_ALSA)
  std::string fault;
  for (CaptureDevice& device : list_alsa_devices(fault)) list.devices.push_back(std::move(device));
  if (!fault.empty()) list.notes.push_back("ALSA: " + fault);
#else
  list.notes.emplace_back("ALSA was left out when this program was built (-DODAS_WITH_ALSA=ON)");
#endif
}

void add_pulse(DeviceList& list) {
#if defined(ODAS_WITH_PULSE)
  PulseClient client;
  const auto deadline = PulseClient::Clock::now() + std::chrono::seconds(3);
  if (const std::string fault = client.connect(deadline, false); !fault.empty()) {
    list.notes.push_back("PulseAudio: no server for this user (" + fault + ")");
    return;
  }
  for (PulseDevice& source : client.sources(deadline)) {
    list.devices.push_back({"PulseAudio", std::move(source.name), std::move(source.description), "",
                            std::move(source.offer), source.monitor});
  }
#else
  list.notes.emplace_back("PulseAudio was left out when this program was built (-DODAS_WITH_PULSE=ON)");
#endif
}

}  // namespace

DeviceList list_devices() {
  DeviceList list;
  add_alsa(list);
  add_pulse(list);
  if (list.devices.empty()) {
    list.notes.emplace_back(
        "no microphone is there: is the array plugged in (lsusb), and are its drivers loaded? A container "
        "needs "
        "--device /dev/snd");
  }
  return list;
}

CaptureDevice ask_device(const std::string& name) {
#if defined(ODAS_WITH_ALSA)
  return ask_alsa_device(name);
#else
  return {"ALSA", name, "", "there is none of this name, and ALSA was left out when this program was built",
          {},     false};
#endif
}

}  // namespace odas
