// SPDX-License-Identifier: MIT
#include "odas/io/target_reader.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

namespace odas {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestTag = decltype(Target::tag)::kCapacity;

/// The direction of a target, of length 1: what a double holds may be too much for a float.
std::optional<Vec3> target_direction(const json& item) {
  double v[3]{};
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    static constexpr const char* kKeys[]{"x", "y", "z"};
    const auto found = item.find(kKeys[i]);
    if (found == item.end() || !found->is_number()) return std::nullopt;
    v[i] = found->get<double>();
    if (!std::isfinite(v[i])) return std::nullopt;
    longest = std::max(longest, std::abs(v[i]));
  }
  if (!(longest > 0)) return std::nullopt;
  for (double& c : v) c /= longest;
  return normalized({static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])});
}

TargetMessage refused_targets(std::string fault) {
  TargetMessage message;
  message.fault = std::move(fault);
  return message;
}

/// Appends the target that `item` describes; the fault, or "".
std::string read_target(const json& item, const std::string& path, std::vector<Target>& targets) {
  if (!item.is_object()) return path + " is no JSON object";
  const auto tag = item.find("tag");
  if (tag == item.end() || !tag->is_string()) return path + ".tag is no text";
  const auto& name = tag->get_ref<const std::string&>();
  if (name.empty()) return "";
  if (name.size() > kLongestTag) return path + ".tag has more than 63 bytes";
  if (name == "dynamic") return path + ".tag is \"dynamic\", the tag of sources that come and go";
  const std::optional<Vec3> direction = target_direction(item);
  if (!direction) return path + " has no direction: x, y and z are numbers, not all 0";
  for (const Target& other : targets) {
    if (other.tag.view() == name) return path + ".tag is the tag of another target";
  }
  targets.push_back({std::string_view(name), *direction});
  return "";
}

}  // namespace

TargetMessage read_targets(std::string_view text) {
  const json content = json::parse(text, nullptr, false);
  if (content.is_discarded()) return refused_targets("is no JSON");
  if (!content.is_object()) return refused_targets("is no JSON object");
  const auto list_of = [&](const char* key) -> const json* {
    const auto found = content.find(key);
    return found == content.end() ? nullptr : &*found;
  };
  const json* const all = list_of("targets");
  const json* const removed = list_of("remove");
  const json* const added = all != nullptr ? all : list_of("add");
  if (added == nullptr && removed == nullptr)
    return refused_targets("has no list \"targets\", \"add\" or \"remove\"");
  const std::string key = all != nullptr ? "targets" : "add";

  TargetMessage good;
  good.replaces = all != nullptr;
  if (removed != nullptr) {
    if (all != nullptr) return refused_targets("has both \"targets\" and \"remove\"");
    if (!removed->is_array()) return refused_targets("has no list \"remove\"");
    for (const json& tag : *removed) {
      if (!tag.is_string()) return refused_targets("remove has what is no text: it is a list of tags");
      good.removed.push_back(tag.get<std::string>());
    }
  }
  if (added == nullptr) return good;
  if (!added->is_array()) return refused_targets("has no list \"" + key + "\"");
  std::vector<Target> targets;
  for (std::size_t i = 0; i < added->size(); ++i) {
    std::string fault = read_target((*added)[i], key + "[" + std::to_string(i) + "]", targets);
    if (!fault.empty()) return refused_targets(std::move(fault));
  }
  good.surplus = good.targets.assign(targets);
  return good;
}

TargetList heed(const TargetMessage& message, const TargetList& before, std::size_t& surplus) {
  surplus = message.surplus;
  if (message.replaces) return message.targets;
  const auto is_removed = [&](const Target& target) {
    return std::find(message.removed.begin(), message.removed.end(), target.tag.view()) !=
           message.removed.end();
  };
  std::vector<Target> all;
  for (const Target& target : before.view()) {
    if (is_removed(target)) continue;
    const Target* moved = message.targets.find(target.tag);
    all.push_back(moved != nullptr ? *moved : target);
  }
  const std::size_t kept = all.size();
  for (const Target& target : message.targets.view()) {
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(kept);
    const auto is_it = [&](const Target& other) { return other.tag == target.tag; };
    if (std::none_of(all.begin(), end, is_it)) all.push_back(target);
  }
  TargetList now;
  surplus += now.assign(all);
  return now;
}

std::optional<TargetMessage> TargetReader::next() {
  const std::optional<JsonCutter::Cut> cut = cutter_.next();
  if (!cut) return std::nullopt;
  return cut->fault != nullptr ? refused_targets(cut->fault) : read_targets(cut->text);
}

}  // namespace odas
