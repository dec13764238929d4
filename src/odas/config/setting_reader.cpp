// SPDX-License-Identifier: MIT
#include "odas/config/setting_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <libconfig.h++>

#include "odas/base/overloaded.hpp"
#include "odas/config/keys.hpp"
#include "odas/config/nearest.hpp"
#include "odas/config/phrases.hpp"

namespace odas {

using libconfig::Setting;

namespace {

constexpr std::array<std::string_view, 1> kIgnoredAtTheTop{"version"};  // in all of ODAS's files, never read

std::string child_path(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string element_path(const std::string& path, int index) {
  return path + "[" + std::to_string(index) + "]";
}

bool has(const Setting* group, std::string_view key) {
  return group != nullptr && group->exists(std::string(key));
}

/// What a setting is, in words.
std::string kind_of(const Setting& setting) {
  switch (setting.getType()) {
    case Setting::TypeInt:
      return "the number " + number_text(static_cast<double>(static_cast<int>(setting)));
    case Setting::TypeInt64:
      return "the number " + number_text(static_cast<double>(static_cast<long long>(setting)));
    case Setting::TypeFloat:
      return "the number " + number_text(static_cast<double>(setting));
    case Setting::TypeString:
      return "the text \"" + std::string(setting.c_str()) + "\"";
    case Setting::TypeBoolean:
      return static_cast<bool>(setting) ? "true" : "false";
    case Setting::TypeGroup:
      return "a group { }";
    default:
      return "a list ( )";
  }
}

std::optional<double> any_number(const Setting& setting) {
  switch (setting.getType()) {
    case Setting::TypeInt:
      return static_cast<double>(static_cast<int>(setting));
    case Setting::TypeInt64:
      return static_cast<double>(static_cast<long long>(setting));
    case Setting::TypeFloat:
      return static_cast<double>(setting);
    default:
      return std::nullopt;
  }
}

struct Found {
  const Field* field = nullptr;
  void* object = nullptr;
};

Found find(std::span<const GroupRef> structs, std::string_view key) {
  for (const GroupRef& ref : structs) {
    for (const Field& field : ref.schema) {
      if (field.key == key) return {&field, ref.object};
    }
  }
  return {};
}

}  // namespace

void SettingReader::read(const Setting& root, Configuration& config) const {
  const std::vector<Section> sections = sections_of(config);
  std::vector<std::string_view> names;
  for (const Section& section : sections) names.push_back(section.name);
  for (int i = 0; i < root.getLength(); ++i) {
    const Setting& setting = root[i];
    const std::string name = setting.getName();
    note(setting, name);
    const bool known = std::find(names.begin(), names.end(), name) != names.end();
    if (known && !setting.isGroup()) error(name, "is " + kind_of(setting) + ", must be a group { }");
    if (known ||
        std::find(kIgnoredAtTheTop.begin(), kIgnoredAtTheTop.end(), name) != kIgnoredAtTheTop.end()) {
      continue;
    }
    const std::string_view near = nearest(name, names);
    warning(name,
            "unknown section, ignored" + (near.empty() ? "" : "; did you mean " + in_quotes(near) + "?"));
  }
  for (const Section& section : sections) {
    const std::string name(section.name);
    if (!has(&root, name)) {
      read_group(nullptr, name, section.groups);
    } else if (root[name.c_str()].isGroup()) {
      read_group(&root[name.c_str()], name, section.groups);
    }
  }
}

void SettingReader::read_group(const Setting* group, const std::string& path, Structs structs) const {
  for (int i = 0; group != nullptr && i < group->getLength(); ++i) {
    const Setting& setting = (*group)[i];
    const std::string key_path = child_path(path, setting.getName());
    note(setting, key_path);
    if (const Found found = find(structs, setting.getName()); found.field == nullptr) {
      read_unknown(setting, key_path, structs);
    } else if (found.field->access_ != nullptr) {
      read_field(setting, key_path, *found.field, found.object);
    }
  }
  for (const GroupRef& ref : structs) {
    for (const Field& field : ref.schema) {
      if (field.access_ == nullptr || has(group, field.key)) continue;
      const std::string key_path = child_path(path, field.key);
      if (field.required && !locations_.has(key_path)) {
        error(key_path,
              "is missing; it describes the hardware and has no default: " + std::string(field.meaning));
      }
      const FieldValue value = field.value(ref.object);
      if (const auto* inner = std::get_if<GroupRef>(&value))
        read_group(nullptr, key_path, std::span(inner, 1));
    }
  }
}

void SettingReader::read_field(const Setting& setting, const std::string& path, const Field& field,
                               void* object) const {
  const auto take = [](auto* target, auto read) {
    if (read) *target = *read;
  };
  std::visit(Overloaded{
                 [&](bool* target) {
                   if (setting.getType() == Setting::TypeBoolean) {
                     *target = static_cast<bool>(setting);
                   } else {
                     error(path, "is " + kind_of(setting) + ", must be true or false");
                   }
                 },
                 [&](int* target) { take(target, integer(setting, path, field)); },
                 [&](float* target) { take(target, number(setting, path, field)); },
                 [&](std::string* target) { take(target, text(setting, path, field)); },
                 [&](std::vector<int>* target) { read_integers(setting, path, field, *target); },
                 [&](std::vector<std::string>* target) { read_texts(setting, path, field, *target); },
                 [&](std::span<float> target) { read_numbers(setting, path, field, target); },
                 [&](const GroupRef& target) {
                   if (setting.isGroup()) return read_group(&setting, path, std::span(&target, 1));
                   error(path, "is " + kind_of(setting) + ", must be a group { }");
                 },
                 [&](const ListRef& target) {
                   if (is_sequence(setting, path, "groups { }")) read_list(setting, path, target);
                 },
             },
             field.value(object));
}

void SettingReader::read_list(const Setting& setting, const std::string& path, const ListRef& list) const {
  list.resize(0);  // so that no default shines through what the user leaves out of an element
  list.resize(static_cast<std::size_t>(setting.getLength()));
  for (int i = 0; i < setting.getLength(); ++i) {
    const std::string item = element_path(path, i);
    note(setting[i], item);
    if (setting[i].isGroup()) {
      const GroupRef element{list.at(static_cast<std::size_t>(i)), list.schema()};
      read_group(&setting[i], item, std::span(&element, 1));
    } else {
      error(item, "is " + kind_of(setting[i]) + ", must be a group { }");
    }
  }
}

void SettingReader::read_unknown(const Setting& setting, const std::string& path, Structs structs) const {
  const std::string name = setting.getName();
  // Old files of ODAS have one group `spatialfilter` where there is a list today.
  const std::string plural = name + "s";
  if (const Found found = find(structs, plural); found.field != nullptr && setting.isGroup()) {
    const FieldValue value = found.field->value(found.object);
    const auto* list = std::get_if<ListRef>(&value);
    if (list != nullptr && !setting.getParent().exists(plural)) {
      note(setting, path + "s");
      note(setting, element_path(path + "s", 0));
      list->resize(0);
      list->resize(1);
      const GroupRef element{list->at(0), list->schema()};
      read_group(&setting, element_path(path + "s", 0), std::span(&element, 1));
      return warning(path, "is the old form; read as " + plural + " = ( { ... } )");
    }
  }
  std::vector<std::string_view> siblings;
  for (const GroupRef& ref : structs) {
    for (const Field& field : ref.schema) siblings.push_back(field.key);
  }
  std::string hint;
  if (const std::string_view near = nearest(name, siblings); !near.empty()) {
    hint = "; did you mean " + in_quotes(near) + "?";
  } else if (const std::string home = home_of_key(name); !home.empty()) {
    hint = "; it belongs to " + home;
  }
  warning(path, "unknown key, ignored" + hint);
}

bool SettingReader::is_sequence(const Setting& setting, const std::string& path, const char* of) const {
  if (setting.isList() || setting.isArray()) return true;
  error(path, "is " + kind_of(setting) + ", must be a list ( ) of " + of);
  return false;
}

void SettingReader::read_numbers(const Setting& setting, const std::string& path, const Field& field,
                                 std::span<float> values) const {
  if (!is_sequence(setting, path, "numbers")) return;
  if (static_cast<std::size_t>(setting.getLength()) != values.size()) {
    return error(path, "has " + std::to_string(setting.getLength()) + " numbers, must have " +
                           std::to_string(values.size()));
  }
  for (int i = 0; i < setting.getLength(); ++i) {
    note(setting[i], element_path(path, i));
    if (const auto value = number(setting[i], element_path(path, i), field)) {
      values[static_cast<std::size_t>(i)] = *value;
    }
  }
}

void SettingReader::read_integers(const Setting& setting, const std::string& path, const Field& field,
                                  std::vector<int>& values) const {
  if (!is_sequence(setting, path, "whole numbers")) return;
  values.clear();
  for (int i = 0; i < setting.getLength(); ++i) {
    note(setting[i], element_path(path, i));
    values.push_back(integer(setting[i], element_path(path, i), field).value_or(0));
  }
}

void SettingReader::read_texts(const Setting& setting, const std::string& path, const Field& field,
                               std::vector<std::string>& values) const {
  if (!is_sequence(setting, path, "texts")) return;
  values.clear();
  for (int i = 0; i < setting.getLength(); ++i) {
    note(setting[i], element_path(path, i));
    values.push_back(text(setting[i], element_path(path, i), field).value_or(""));
  }
}

std::optional<double> SettingReader::in_range(double value, const std::string& path,
                                              const Field& field) const {
  const std::string unit = field.unit.empty() ? "" : " " + std::string(field.unit);
  if (!std::isfinite(value)) {
    error(path, "is not finite");
  } else if (!field.range.contains(value)) {
    error(path, "is " + number_text(value) + unit + ", must be " + range_text(field.range) + unit);
  } else {
    return value;
  }
  return std::nullopt;
}

std::optional<float> SettingReader::number(const Setting& setting, const std::string& path,
                                           const Field& field) const {
  const auto value = any_number(setting);
  if (!value) {
    error(path, "is " + kind_of(setting) + ", must be a number");
    return std::nullopt;
  }
  // As a float: 1e-60 is zero then, and 1e60 has no end.
  const auto single = static_cast<float>(*value);
  const bool changed = !std::isfinite(single) || (single == 0) != (*value == 0);
  if (!in_range(changed ? static_cast<double>(single) : *value, path, field)) return std::nullopt;
  return single;
}

std::optional<int> SettingReader::integer(const Setting& setting, const std::string& path,
                                          const Field& field) const {
  const auto value = any_number(setting);
  if (!value || (std::isfinite(*value) && *value != std::trunc(*value))) {
    error(path, "is " + kind_of(setting) + ", must be a whole number");
    return std::nullopt;
  }
  if (!in_range(*value, path, field)) return std::nullopt;
  if (std::abs(*value) > std::numeric_limits<int>::max()) {
    error(path, "is " + number_text(*value) + ", which is too large");
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<std::string> SettingReader::text(const Setting& setting, const std::string& path,
                                               const Field& field) const {
  if (setting.getType() != Setting::TypeString) {
    error(path, "is " + kind_of(setting) + ", must be a text in quotes");
    return std::nullopt;
  }
  std::string value = setting.c_str();
  if (!field.choices.empty() &&
      std::find(field.choices.begin(), field.choices.end(), value) == field.choices.end()) {
    const std::string_view near = nearest(value, field.choices);
    error(path, "is " + in_quotes(value) + ", must be " + choices_text(field.choices) +
                    (near.empty() ? "" : "; did you mean " + in_quotes(near) + "?"));
    return std::nullopt;
  }
  return value;
}

void SettingReader::note(const Setting& setting, const std::string& path) const {
  locations_.add(path, source_.location(static_cast<int>(setting.getSourceLine())));
}

void SettingReader::error(const std::string& path, std::string what) const {
  faults_.push_back(locations_.locate({Fault::Severity::error, path, std::move(what), "", 0}));
}

void SettingReader::warning(const std::string& path, std::string what) const {
  faults_.push_back(locations_.locate({Fault::Severity::warning, path, std::move(what), "", 0}));
}

}  // namespace odas
