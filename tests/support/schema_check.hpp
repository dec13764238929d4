// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "odas/base/field.hpp"

namespace odas::test {

inline void expect_sound(GroupRef group);

/// The value of one field lies in the field's own range, and among its choices.
inline void expect_sound_value(const Field& field, const FieldValue& value) {
  const auto in_range = [&](double x) { EXPECT_TRUE(field.range.contains(x)) << field.key << " = " << x; };
  if (const auto* number = std::get_if<int*>(&value)) in_range(**number);
  if (const auto* number = std::get_if<float*>(&value)) in_range(static_cast<double>(**number));
  if (const auto* numbers = std::get_if<std::vector<int>*>(&value)) {
    for (const int x : **numbers) in_range(x);
  }
  if (const auto* numbers = std::get_if<std::span<float>>(&value)) {
    for (const float x : *numbers) in_range(static_cast<double>(x));
  }
  if (const auto* text = std::get_if<std::string*>(&value); text != nullptr && !field.choices.empty()) {
    EXPECT_NE(std::find(field.choices.begin(), field.choices.end(), **text), field.choices.end())
        << field.key;
  }
  if (const auto* group = std::get_if<GroupRef>(&value)) expect_sound(*group);
  if (const auto* list = std::get_if<ListRef>(&value)) {
    for (std::size_t i = 0; i < list->size(); ++i) expect_sound({list->at(i), list->schema()});
  }
}

/// Keys are unique, every field says what it means, and every default is one that a user could write.
inline void expect_sound(GroupRef group) {
  std::set<std::string_view> keys;
  for (const Field& field : group.schema) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key << " stands twice";
    EXPECT_FALSE(field.meaning.empty()) << field.key;
    const bool has_default = field.access_ != nullptr && !field.required;
    if (has_default) expect_sound_value(field, field.value(group.object));
  }
  EXPECT_FALSE(keys.empty());
}

template <class Config>
void expect_sound_defaults() {
  Config config;
  expect_sound({&config, Config::schema()});
}

}  // namespace odas::test
