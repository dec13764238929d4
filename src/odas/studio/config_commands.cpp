// SPDX-License-Identifier: MIT
#include "odas/studio/config_commands.hpp"

#include "odas/config/array_library.hpp"
#include "odas/config/describe.hpp"
#include "odas/io/device_list.hpp"
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

}  // namespace

void add_config_methods(RpcRegistry& rpc, EngineHost& host) {
  rpc.add("config.check", Role::viewer, "what is wrong with a text, and what applying it would do",
          [&host](const json& params) { return check(params, host); });
  rpc.add("arrays.list", Role::viewer, "the arrays that are known by name",
          [](const json&) { return list_arrays(); });
  rpc.add("arrays.get", Role::viewer, "the configuration of one of them", get_array);
}

}  // namespace odas
