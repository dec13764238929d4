// SPDX-License-Identifier: MIT
#include "odas/studio/config_form.hpp"

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "odas/base/overloaded.hpp"
#include "odas/studio/config_values.hpp"

namespace odas {

using nlohmann::json;

namespace {

const char* kind_of(const FieldValue& value) {
  return std::visit(
      Overloaded{[](bool*) { return "bool"; }, [](int*) { return "int"; }, [](float*) { return "float"; },
                 [](std::string*) { return "string"; }, [](std::vector<int>*) { return "ints"; },
                 [](std::vector<std::string>*) { return "strings"; },
                 [](std::span<float>) { return "floats"; }, [](const GroupRef&) { return "group"; },
                 [](const ListRef&) { return "list"; }},
      value);
}

json bound(double value) { return std::isfinite(value) ? json(value) : json(); }

/// Describes fields, with values of one object and defaults of another of the same kind.
class FormMaker {
 public:
  explicit FormMaker(const Locations& locations) : locations_(locations) {}

  [[nodiscard]] json fields(const std::string& path, Schema schema, void* object, void* standard) const {
    json all = json::array();
    for (const Field& one : schema) {
      if (one.access_ != nullptr) {
        all.push_back(field(path + "." + std::string(one.key), one, object, standard));
      }
    }
    return all;
  }

 private:
  [[nodiscard]] json field(const std::string& path, const Field& one, void* object, void* standard) const {
    const FieldValue value = one.value(object);
    const bool written = locations_.has(path);
    json made{{"path", path},       {"key", one.key},           {"kind", kind_of(value)},
              {"unit", one.unit},   {"meaning", one.meaning},   {"choices", one.choices},
              {"written", written}, {"required", one.required}, {"line", nullptr}};
    made["min"] = bound(one.range.min);
    made["max"] = bound(one.range.max);
    made["min_excluded"] = one.range.min_excluded;
    if (written) made["line"] = locations_.find(path).line;
    if (const auto* group = std::get_if<GroupRef>(&value)) {
      const auto standard_group = std::get<GroupRef>(one.value(standard));
      made["fields"] = fields(path, group->schema, group->object, standard_group.object);
    } else if (const auto* list = std::get_if<ListRef>(&value)) {
      add_list(made, path, *list, std::get<ListRef>(one.value(standard)));
    } else {
      made["value"] = value_of(one, object);
      // Of a key that follows another one: what that one says now.
      made["default"] = !one.derived.empty() && !written ? made["value"] : value_of(one, standard);
      if (const auto* floats = std::get_if<std::span<float>>(&value)) made["length"] = floats->size();
    }
    return made;
  }

  void add_list(json& made, const std::string& path, const ListRef& list, const ListRef& standard) const {
    made["items"] = json::array();
    const std::size_t before = standard.size();
    standard.resize(before + 1);  // one that is as new
    void* const fresh = standard.at(before);
    for (std::size_t i = 0; i < list.size(); ++i) {
      made["items"].push_back(fields(path + "[" + std::to_string(i) + "]", list.schema(), list.at(i), fresh));
    }
    made["item"] = FormMaker(Locations()).fields(path + "[]", list.schema(), fresh, fresh);
    standard.resize(before);
  }

  const Locations& locations_;
};

json written(const Field& field, void* object, const std::string& path, const Locations& locations);

json written_group(Schema schema, void* object, const std::string& path, const Locations& locations) {
  json group = json::object();
  for (const Field& field : schema) {
    if (field.access_ == nullptr) continue;
    const std::string key(field.key);
    json value = written(field, object, path + "." + key, locations);
    if (!value.is_null()) group[key] = std::move(value);
  }
  return group;
}

json written(const Field& field, void* object, const std::string& path, const Locations& locations) {
  if (!locations.has(path)) return nullptr;
  const FieldValue value = field.value(object);
  if (const auto* group = std::get_if<GroupRef>(&value)) {
    return written_group(group->schema, group->object, path, locations);
  }
  if (const auto* list = std::get_if<ListRef>(&value)) {
    json items = json::array();
    for (std::size_t i = 0; i < list->size(); ++i) {
      items.push_back(
          written_group(list->schema(), list->at(i), path + "[" + std::to_string(i) + "]", locations));
    }
    return items;
  }
  return value_of(field, object);
}

}  // namespace

json config_form(LoadedConfiguration loaded) {
  Configuration standard;
  const FormMaker maker(loaded.locations);
  const std::vector<Section> with_values = sections_of(loaded.config), with_defaults = sections_of(standard);
  json sections = json::array();
  for (std::size_t s = 0; s < with_values.size(); ++s) {
    const Section& section = with_values[s];
    json fields = json::array();
    for (std::size_t g = 0; g < section.groups.size(); ++g) {
      const GroupRef& group = section.groups[g];
      const json more = maker.fields(std::string(section.name), group.schema, group.object,
                                     with_defaults[s].groups[g].object);
      fields.insert(fields.end(), more.begin(), more.end());
    }
    sections.push_back({{"name", section.name}, {"fields", std::move(fields)}});
  }
  return {{"sections", std::move(sections)}};
}

json written_value(LoadedConfiguration& loaded, std::string_view section, std::string_view key) {
  const std::string path = std::string(section) + "." + std::string(key);
  for (const Section& one : sections_of(loaded.config)) {
    if (one.name != section) continue;
    for (const GroupRef& group : one.groups) {
      for (const Field& field : group.schema) {
        if (field.key == key && field.access_ != nullptr) {
          return written(field, group.object, path, loaded.locations);
        }
      }
    }
  }
  return nullptr;
}

}  // namespace odas
