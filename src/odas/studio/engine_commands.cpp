// SPDX-License-Identifier: MIT
#include "odas/studio/engine_commands.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "odas/config/array_library.hpp"
#include "odas/studio/config_edit.hpp"

namespace odas {

using nlohmann::json;

namespace {

/// What is wrong with a configuration is no failure of the command.
template <class Act>
json or_invalid(Act&& act) {
  try {
    return act();
  } catch (const ConfigError& error) { throw invalid(error); }
}

Document document_of(const json& params) {
  Document document;
  if (params.contains("array")) {
    document = read_document(params.at("array").get<std::string>());
    if (params.contains("source")) document.text = with_source(document, params.at("source"));
    return document;
  }
  document.text = params.at("config").get<std::string>();
  document.name = params.value("name", "unnamed");
  return document;
}

Target target_of(const json& order) {
  const auto tag = order.at("tag").get<std::string>();
  if (tag.size() > 63) throw RpcError("bad_request", "a tag has at most 63 bytes");
  const auto direction = order.at("direction").get<std::array<float, 3>>();
  Target target;
  target.tag = std::string_view(tag);
  target.direction = {direction[0], direction[1], direction[2]};
  if (const std::string fault = fault_of(target); !fault.empty()) {
    throw RpcError("bad_request", "target \"" + tag + "\" " + fault);
  }
  return target;
}

/// Lists of the two kinds, as they are being changed.
struct Lists {
  std::vector<Target> targets, muted;

  explicit Lists(const TargetInbox::Orders& orders)
      : targets(orders.targets.view().begin(), orders.targets.view().end()),
        muted(orders.muted.view().begin(), orders.muted.view().end()) {}

  void remove(std::string_view tag) {
    for (auto* list : {&targets, &muted}) {
      std::erase_if(*list, [&](const Target& target) { return target.tag.view() == tag; });
    }
  }
  void add(const json& order) {
    const Target target = target_of(order);
    remove(target.tag.view());
    std::vector<Target>& list = order.value("mute", false) ? muted : targets;
    if (list.size() == TargetList::kCapacity) {
      throw RpcError("bad_request", "64 targets are the most, and 64 muted directions");
    }
    list.push_back(target);
  }
};

json set_targets(EngineHost& host, Announcer& to, const json& params) {
  TargetInbox::Orders now;
  const bool runs = host.change_targets([&](TargetInbox::Orders& orders) {
    Lists lists(params.contains("targets") ? TargetInbox::Orders{} : orders);
    for (const json& order : params.value("targets", json::array())) lists.add(order);
    for (const json& tag : params.value("remove", json::array())) lists.remove(tag.get<std::string>());
    for (const json& order : params.value("add", json::array())) lists.add(order);
    TargetInbox::Orders next;
    next.targets.assign(lists.targets);
    next.muted.assign(lists.muted);
    now = orders = next;
  });
  if (!runs) throw RpcError("conflict", "nothing runs: start the engine first");
  const json list = targets_json(now);
  to.announce("", {{"type", "targets"}, {"targets", list}});
  return {{"targets", list}};
}

json save(EngineHost& host, const json& params) {
  std::filesystem::path file;
  if (const std::string name = params.value("name", ""); !name.empty()) {
    const auto is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
    if (!std::all_of(name.begin(), name.end(), is_plain) || name.size() > 64) {
      throw RpcError("bad_request", "a name has letters, digits, '_' and '-', 64 at most");
    }
    const std::filesystem::path folder = user_array_folder();
    if (folder.empty()) throw RpcError("failed", "there is no home to save to: set HOME or XDG_CONFIG_HOME");
    file = folder / (name + ".cfg");
  } else {
    file = host.status().document.file;
    if (file.empty()) throw RpcError("bad_request", "it came from no file: give a name");
  }
  host.save(file);
  return {{"file", file.string()}};
}

json get(const EngineHost::Status& status) {
  return {{"text", status.document.text},
          {"name", status.document.name},
          {"hash", hash_of(status.document.text)},
          {"dirty", status.dirty},
          {"previous", status.has_previous}};
}

}  // namespace

json faults_json(const std::vector<Fault>& faults) {
  json list = json::array();
  for (const Fault& fault : faults) {
    list.push_back({{"path", fault.path},
                    {"line", fault.line},
                    {"severity", fault.severity == Fault::Severity::error ? "error" : "warning"},
                    {"what", fault.what}});
  }
  return list;
}

RpcError invalid(const ConfigError& error) {
  return {"invalid", error.what(), {{"faults", faults_json(error.faults())}}};
}

json targets_json(const TargetInbox::Orders& orders) {
  json list = json::array();
  const auto add = [&](const TargetList& targets, bool mute) {
    for (const Target& target : targets.view()) {
      const Vec3 u = target.direction;
      list.push_back({{"tag", target.tag.view()}, {"direction", {u.x, u.y, u.z}}, {"mute", mute}});
    }
  };
  add(orders.targets, false);
  add(orders.muted, true);
  return list;
}

void add_engine_methods(RpcRegistry& rpc, EngineHost& host, Announcer& to) {
  const auto done = [](const auto& act) {
    return [act](const json&) {
      return or_invalid([&]() -> json {
        act();
        return json::object();
      });
    };
  };
  rpc.add("engine.start", Role::operator_, "run what is open from its beginning",
          done([&host] { host.start(); }));
  rpc.add("engine.restart", Role::operator_, "the same, also while it runs", done([&host] { host.start(); }));
  rpc.add("engine.stop", Role::operator_, "end the run, with all files finished",
          done([&host] { host.stop(); }));
  rpc.add("engine.open", Role::operator_, "run a configuration, or an array with a source",
          [&host](const json& params) {
            return or_invalid([&]() -> json {
              host.open(document_of(params));
              return json::object();
            });
          });
  rpc.add("config.get", Role::viewer, "the configuration that is open",
          [&host](const json&) { return get(host.status()); });
  rpc.add("config.apply", Role::operator_, "run by another text, as gently as can be",
          [&host](const json& params) {
            return or_invalid([&]() -> json {
              return {{"effect", name_of(host.apply(params.at("text").get<std::string>()))}};
            });
          });
  rpc.add("config.revert", Role::operator_, "back to the text before the last apply", [&host](const json&) {
    return or_invalid([&]() -> json { return {{"effect", name_of(host.revert())}}; });
  });
  rpc.add("config.save", Role::operator_, "write the configuration to its file, or by a name",
          [&host](const json& params) { return save(host, params); });
  rpc.add("targets.set", Role::operator_, "follow fixed directions, or mute them",
          [&host, &to](const json& params) { return set_targets(host, to, params); });
}

}  // namespace odas
