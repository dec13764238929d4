// SPDX-License-Identifier: MIT
#include "odas/studio/config_commands.hpp"

#include <algorithm>
#include <utility>

#include "odas/config/array_library.hpp"
#include "odas/config/describe.hpp"
#include "odas/io/device_list.hpp"
#include "odas/studio/array_check.hpp"
#include "odas/studio/config_edit.hpp"
#include "odas/studio/config_form.hpp"
#include "odas/studio/engine_commands.hpp"

namespace odas {

using nlohmann::json;

namespace {

/// The text that a command is about: its own, or that which is open.
Document document_of(const json& params, const EngineHost& host) {
  Document document = host.status().document;
  if (params.contains("text")) document.text = params.at("text").get<std::string>();
  if (document.name.empty()) document.name = "unnamed";
  return document;
}

json check(const json& params, const EngineHost& host) {
  const Document document = document_of(params, host);
  const LoadedConfiguration loaded = read_configuration_text(document.text, document.source_name());
  json answer{{"faults", faults_json(loaded.faults)}, {"plan", ""}, {"effect", "none"}};
  if (!loaded.ok()) return answer;
  try {
    const CheckedDocument checked = check_document(document, Outputs::network);
    answer["plan"] = describe_plan(loaded.config, checked.pipeline->plan());
    answer["effect"] = name_of(host.effect_of(document.text));
  } catch (const ConfigError& error) {
    for (const json& fault : faults_json(error.faults())) answer["faults"].push_back(fault);
  }
  return answer;
}

json list_arrays() {
  json list = json::array();
  for (const ArrayFile& file : array_files(array_folders())) {
    list.push_back({{"name", file.name}, {"title", file.title}});
  }
  return list;
}

json get_array(const json& params) {
  try {
    return {{"text", read_document(params.at("name").get<std::string>()).text}};
  } catch (const ConfigError& error) { throw RpcError("not_found", error.what()); }
}

json form(const json& params, const EngineHost& host) {
  const Document document = document_of(params, host);
  LoadedConfiguration loaded = read_configuration_text(document.text, document.source_name());
  // What cannot be parsed has no fields: who asks must not take the defaults for them.
  const auto is_syntax = [](const Fault& fault) {
    return fault.severity == Fault::Severity::error && fault.path.empty();
  };
  if (std::any_of(loaded.faults.begin(), loaded.faults.end(), is_syntax)) {
    throw invalid(ConfigError(std::move(loaded.faults)));
  }
  return config_form(std::move(loaded));
}

json edit(const json& params, const EngineHost& host) {
  const Document document = document_of(params, host);
  const std::string name = document.source_name();
  try {
    const std::string text = with_changes(document.text, name, params.at("changes"));
    return {{"text", text}, {"faults", faults_json(read_configuration_text(text, name).faults)}};
  } catch (const ConfigError& error) { throw RpcError("bad_request", error.what()); }
}

json devices() {
  json list = json::array();
  for (const CaptureDevice& device : list_devices().devices) {
    if (device.monitor || !device.problem.empty()) continue;
    const CaptureOffer& offer = device.offer;
    json formats = json::array();
    for (const SampleFormat format : offer.formats) formats.push_back(name_of(format));
    list.push_back({{"interface", device.system == "PulseAudio" ? "pulseaudio" : "soundcard_name"},
                    {"name", device.name},
                    {"title", device.description},
                    {"channels", offer.channels},
                    {"rates", offer.rates},
                    {"formats", std::move(formats)},
                    {"raw", propose_raw(offer, interface_text(device))}});
  }
  return list;
}

}  // namespace

void add_config_methods(RpcRegistry& rpc, EngineHost& host) {
  rpc.add("config.check", Role::viewer, "what is wrong with a text, and what applying it would do",
          [&host](const json& params) { return check(params, host); });
  rpc.add("config.form", Role::viewer, "a text as a form: its fields, what they mean, what may stand there",
          [&host](const json& params) { return form(params, host); });
  rpc.add("config.edit", Role::viewer, "a text after changes of some settings",
          [&host](const json& params) { return edit(params, host); });
  rpc.add("array.check", Role::viewer, "what the geometry of an array lets it hear",
          [&host](const json& params) {
            const Document document = document_of(params, host);
            return check_array(read_configuration_text(document.text, document.source_name()));
          });
  rpc.add("devices.list", Role::viewer, "microphones of this machine, and what each offers",
          [](const json&) { return devices(); });
  rpc.add("arrays.list", Role::viewer, "the arrays that are known by name",
          [](const json&) { return list_arrays(); });
  rpc.add("arrays.get", Role::viewer, "the configuration of one of them", get_array);
}

}  // namespace odas
