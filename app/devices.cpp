// SPDX-License-Identifier: MIT
// odas devices: what there is to listen to, and how.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include <CLI/CLI.hpp>

#include "odas/base/error.hpp"
#include "odas/io/device_list.hpp"

namespace odas {

namespace {

void list(const std::string& name, bool json) {
  DeviceList list = list_devices();
  std::vector<CaptureDevice>& devices = list.devices;
  if (!name.empty()) {
    std::erase_if(devices, [&](const CaptureDevice& device) { return device.name != name; });
    // It may have no entry in any list and yet be known by its name.
    if (devices.empty()) devices.push_back(ask_device(name));
    if (!json && !devices.front().problem.empty()) throw IoError(name + ": " + devices.front().problem);
  }
  std::cout << (json ? devices_json(devices) : describe_devices(devices)) << std::flush;
  if (!std::cout) throw IoError("cannot write to standard output");
  if (!name.empty()) return;
  for (const std::string& note : list.notes) std::cerr << "odas: " << note << '\n';
}

}  // namespace

void add_devices(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("devices", "List microphones: what each offers, and its `raw` section");
  command->footer(
      "Lists the sound cards (ALSA) and the sources of PulseAudio or PipeWire, each with the channels, "
      "rates\n"
      "and formats that it really has, and with the section `raw` of a configuration for it, ready to "
      "paste.\n"
      "Nothing is started and nothing is recorded.\n\n"
      "Examples:\n"
      "  odas devices\n"
      "  odas devices hw:CARD=Array,DEV=0\n"
      "  odas devices --json | jq -r '.[].name'");
  auto name = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command->add_option("NAME", *name, "Only this one, by its name in ALSA or PulseAudio")->type_name("");
  command->add_flag("--json", *json, "Print a JSON array");
  command->callback([name, json] { list(*name, *json); });
}

}  // namespace odas
