// SPDX-License-Identifier: MIT
#include "odas/studio/effect.hpp"

#include <array>

#include "odas/studio/config_values.hpp"

namespace odas {
namespace {

using nlohmann::json;

/// What is made once for a run beside its pipeline: the way in, and all ways out.
json fixed_parts(const json& values) {
  json parts{{"mapping", values.at("mapping")}};
  static const std::array<json::json_pointer, 8> kOutputs{
      json::json_pointer("/ssl/potential"), json::json_pointer("/sst/tracked"),
      json::json_pointer("/sst/control"),   json::json_pointer("/sss/separated"),
      json::json_pointer("/sss/gain_sep"),  json::json_pointer("/sss/postfiltered"),
      json::json_pointer("/sss/gain_pf"),   json::json_pointer("/classify/category")};
  for (const auto& output : kOutputs) parts[output.to_string()] = values.value(output, json());
  return parts;
}

}  // namespace

const char* name_of(Effect effect) noexcept {
  static constexpr std::array<const char*, 4> kNames{"none", "live", "restart", "reopen"};
  return kNames[static_cast<std::size_t>(effect)];
}

Effect effect_of(const Configuration& before, const Configuration& after, bool same_shapes) {
  json old_values = values_of(before), new_values = values_of(after);
  // The page itself: read when the program starts.
  old_values.erase("studio");
  new_values.erase("studio");
  if (old_values == new_values) return Effect::none;
  if (old_values.at("raw") != new_values.at("raw")) return Effect::reopen;
  if (!same_shapes || fixed_parts(old_values) != fixed_parts(new_values)) return Effect::restart;
  return Effect::live;
}

}  // namespace odas
