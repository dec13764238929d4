// SPDX-License-Identifier: MIT
#include "odas/config/defaults.hpp"

#include <map>

namespace odas {

namespace {

struct Derived {
  int* value;
  std::string path;
  std::string from;
};

/// All whole numbers outside of lists, by path, and those that are derived from others.
struct Numbers {
  std::map<std::string, int*, std::less<>> all;
  std::vector<Derived> derived;

  void add(const std::string& path, const GroupRef& group) {
    for (const Field& field : group.schema) {
      if (field.access_ == nullptr) continue;
      const std::string key = path + "." + std::string(field.key);
      const FieldValue value = field.value(group.object);
      if (const auto* inner = std::get_if<GroupRef>(&value)) {
        add(key, *inner);
      } else if (const auto* number = std::get_if<int*>(&value)) {
        all[key] = *number;
        if (!field.derived.empty()) derived.push_back({*number, key, std::string(field.derived)});
      }
    }
  }
};

}  // namespace

void set_derived_defaults(Configuration& config, const Locations& locations) {
  Numbers numbers;
  for (const Section& section : sections_of(config)) {
    for (const GroupRef& group : section.groups) numbers.add(std::string(section.name), group);
  }
  for (const Derived& number : numbers.derived) {
    const auto source = numbers.all.find(number.from);
    if (source != numbers.all.end() && !locations.has(number.path)) *number.value = *source->second;
  }
}

}  // namespace odas
