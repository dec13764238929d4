// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace odas {

/// What a number may be. Bounds are included unless said otherwise.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_excluded = false;

  [[nodiscard]] bool contains(double value) const noexcept {
    return (min_excluded ? value > min : value >= min) && value <= max;
  }
};

inline constexpr Range kAny{};
inline constexpr Range kPositive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range kNotNegative{0};
inline constexpr Range kUnit{0, 1};

class Field;
/// The fields of one configuration struct, as `static Schema schema()` of that struct gives them.
using Schema = std::span<const Field>;

/// A struct within a struct.
struct GroupRef {
  void* object = nullptr;
  Schema schema;
};

/// A list of structs of one kind, of any length. `std::optional` lists tell absent from empty.
class ListRef {
 public:
  template <class T>
  requires requires { T::schema(); }
  explicit ListRef(std::vector<T>* list)
      : list_(list),
        schema_(T::schema()),
        size_([](const void* p) { return static_cast<const std::vector<T>*>(p)->size(); }),
        resize_([](void* p, std::size_t n) { static_cast<std::vector<T>*>(p)->resize(n); }),
        at_([](void* p, std::size_t i) -> void* { return &(*static_cast<std::vector<T>*>(p))[i]; }) {}
  template <class T>
  requires requires { T::schema(); }
  explicit ListRef(std::optional<std::vector<T>>* list)
      : list_(list),
        schema_(T::schema()),
        size_([](const void* p) {
          const auto& l = *static_cast<const std::optional<std::vector<T>>*>(p);
          return l ? l->size() : 0;
        }),
        resize_([](void* p, std::size_t n) {
          auto& l = *static_cast<std::optional<std::vector<T>>*>(p);
          if (!l) l.emplace();
          l->resize(n);
        }),
        at_([](void* p, std::size_t i) -> void* {
          return &(**static_cast<std::optional<std::vector<T>>*>(p))[i];
        }) {}

  [[nodiscard]] Schema schema() const noexcept { return schema_; }
  [[nodiscard]] std::size_t size() const { return size_(list_); }
  void resize(std::size_t n) const { resize_(list_, n); }
  [[nodiscard]] void* at(std::size_t i) const { return at_(list_, i); }

 private:
  void* list_;
  Schema schema_;
  std::size_t (*size_)(const void*);
  void (*resize_)(void*, std::size_t);
  void* (*at_)(void*, std::size_t);
};

/// A field's value within one configuration object. `span<float>` is a vector of fixed length.
using FieldValue = std::variant<bool*, int*, float*, std::string*, std::vector<int>*,
                                std::vector<std::string>*, std::span<float>, GroupRef, ListRef>;

/// One key of the configuration, said once: the reader, the checks, `odas check`, the reference page and
/// the Studio's form all follow from it.
class Field {
 public:
  std::string_view key;
  std::string_view unit;                    // "" where it has none
  Range range;                              // of each number
  std::string_view meaning;                 // one line
  std::vector<std::string_view> choices{};  // of a string; empty: any
  bool required = false;                    // describes the hardware: has no default
  std::string_view derived{};               // path of the key whose value is the default

  [[nodiscard]] FieldValue value(void* object) const { return access_(object); }

  Field must() && {
    required = true;
    return std::move(*this);
  }
  Field defaults_to(std::string_view path) && {
    derived = path;
    return std::move(*this);
  }

  FieldValue (*access_)(void*) = nullptr;
};

namespace detail {
template <auto Member, class C, class T>
FieldValue access(void* object, T C::*) {
  T& member = static_cast<C*>(object)->*Member;
  if constexpr (requires { T::schema(); }) {
    return GroupRef{&member, T::schema()};
  } else if constexpr (requires { ListRef(&member); }) {
    return ListRef(&member);
  } else if constexpr (requires { std::span<float>(member); } && !std::is_same_v<T, std::vector<int>>) {
    return std::span<float>(member);
  } else {
    return &member;
  }
}
}  // namespace detail

/// `field<&Config::member>("key", "unit", range, "meaning")`
template <auto Member>
Field field(std::string_view key, std::string_view unit, Range range, std::string_view meaning,
            std::vector<std::string_view> choices = {}) {
  Field f;
  f.key = key;
  f.unit = unit;
  f.range = range;
  f.meaning = meaning;
  f.choices = std::move(choices);
  f.access_ = [](void* object) { return detail::access<Member>(object, Member); };
  return f;
}

/// A key that ODAS's files carry and that has no effect: known, so that nobody is warned of it.
inline Field ignored_field(std::string_view key, std::string_view meaning) {
  Field f;
  f.key = key;
  f.meaning = meaning;
  return f;
}

}  // namespace odas
