// SPDX-License-Identifier: MIT
#include "odas/studio/config_values.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

#include "odas/base/overloaded.hpp"
#include "odas/config/phrases.hpp"

namespace odas {

using nlohmann::json;

namespace {

/// As it was written: 0.1, not 0.10000000149.
json number(float value) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(number_text(value).c_str(), nullptr);
}

json group_values(Schema schema, void* object) {
  json values = json::object();
  for (const Field& field : schema) {
    if (field.access_ != nullptr) values[std::string(field.key)] = value_of(field, object);
  }
  return values;
}

}  // namespace

json value_of(const Field& field, void* object) {
  if (field.access_ == nullptr) return nullptr;
  return std::visit(Overloaded{
                        [](const GroupRef& group) { return group_values(group.schema, group.object); },
                        [](const ListRef& list) {
                          json items = json::array();
                          for (std::size_t i = 0; i < list.size(); ++i) {
                            items.push_back(group_values(list.schema(), list.at(i)));
                          }
                          return items;
                        },
                        [](std::span<float> values) {
                          json numbers = json::array();
                          for (const float value : values) numbers.push_back(number(value));
                          return numbers;
                        },
                        [](float* value) { return number(*value); },
                        [](auto* value) { return json(*value); },
                    },
                    field.value(object));
}

json values_of(Configuration config) {
  json values = json::object();
  for (const Section& section : sections_of(config)) {
    json& part = values[std::string(section.name)] = json::object();
    for (const GroupRef& group : section.groups) part.update(group_values(group.schema, group.object));
  }
  return values;
}

}  // namespace odas
