// SPDX-License-Identifier: MIT
#include "odas/config/keys.hpp"

#include <vector>

#include "odas/base/overloaded.hpp"
#include "odas/config/phrases.hpp"
#include "odas/engine/config.hpp"

namespace odas {

namespace {

struct Key {
  std::string path;
  const Field* field;
  std::string standard;  // the default
};

template <class Range, class Text>
std::string list_text(const Range& values, Text text) {
  std::string all = "(";
  for (const auto& value : values) all += (all.size() > 1 ? ", " : "") + text(value);
  return all + ")";
}

/// All keys below a struct, groups before what is in them, in the order of the schema.
class Collector {
 public:
  void add(const std::string& path, Schema schema, void* object) {
    for (const Field& field : schema) {
      const std::string key = path + "." + std::string(field.key);
      if (field.access_ == nullptr) {
        keys_.push_back({key, &field, ""});
        continue;
      }
      std::visit(
          Overloaded{
              [&](const GroupRef& group) { add(key, group.schema, group.object); },
              [&](const ListRef& list) { add_list(key, field, list); },
              [&](bool* value) {
                keys_.push_back({key, &field, *value ? "true" : "false"});
              },
              [&](int* value) {
                keys_.push_back({key, &field, std::to_string(*value)});
              },
              [&](float* value) {
                keys_.push_back({key, &field, number_text(*value)});
              },
              [&](std::string* value) {
                keys_.push_back({key, &field, in_quotes(*value)});
              },
              [&](std::vector<int>* values) {
                keys_.push_back({key, &field, list_text(*values, [](int v) { return std::to_string(v); })});
              },
              [&](std::vector<std::string>* values) {
                keys_.push_back({key, &field, list_text(*values, in_quotes)});
              },
              [&](std::span<float> values) {
                keys_.push_back({key, &field, list_text(values, [](float v) { return number_text(v); })});
              },
          },
          field.value(object));
    }
  }

  std::vector<Key> take() { return std::move(keys_); }

 private:
  /// One line for the list with its default, then the keys of an element.
  void add_list(const std::string& key, const Field& field, const ListRef& list) {
    std::string standard = list.size() == 0 ? "" : "(";
    for (std::size_t i = 0; i < list.size(); ++i) {
      Collector element;
      element.add("", list.schema(), list.at(i));
      std::string text;
      for (const Key& k : element.keys_) {
        text += (text.empty() ? "" : " ") + k.path.substr(1) + " = " + k.standard + ";";
      }
      standard += (i > 0 ? ", { " : "{ ") + text + " }";
    }
    keys_.push_back({key, &field, standard.empty() ? "" : standard + ")"});
    list.resize(0);
    list.resize(1);
    add(key + "[]", list.schema(), list.at(0));
  }

  std::vector<Key> keys_;
};

std::vector<Key> keys_of(const Section& section) {
  Collector collector;
  for (const GroupRef& group : section.groups)
    collector.add(std::string(section.name), group.schema, group.object);
  return collector.take();
}

/// What may stand there, in words.
std::string allowed(const Field& field) {
  std::string text = field.choices.empty() ? range_text(field.range) : choices_text(field.choices);
  if (!field.unit.empty()) text += (text.empty() ? "" : " ") + std::string(field.unit);
  return text;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

}  // namespace

std::string key_reference() {
  Configuration config;
  std::string text;
  for (const Section& section : sections_of(config)) {
    text += (text.empty() ? "### " : "\n### ") + std::string(section.name) + "\n\n";
    text += "| key | default | allowed | meaning |\n|---|---|---|---|\n";
    for (const Key& key : keys_of(section)) {
      const bool ignored = key.field->access_ == nullptr;
      const std::string standard = key.field->required ? "**required**"
                                   : ignored           ? "ignored"
                                   : !key.field->derived.empty()
                                       ? "that of " + code(std::string(key.field->derived))
                                       : code(key.standard);
      text += "| `" + key.path + "` | " + standard + " | " + allowed(*key.field) + " | " +
              std::string(key.field->meaning) + " |\n";
    }
  }
  return text;
}

std::string home_of_key(std::string_view key) {
  Configuration config;
  std::string home;
  for (const Section& section : sections_of(config)) {
    for (const Key& known : keys_of(section)) {
      if (known.field->key != key || known.field->access_ == nullptr) continue;
      if (!home.empty()) return "";
      home = known.path;
    }
  }
  return home;
}

}  // namespace odas
