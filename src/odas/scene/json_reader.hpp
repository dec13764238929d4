// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "odas/base/error.hpp"
#include "odas/base/vec3.hpp"

namespace odas {

/// The numbers that a key may have.
struct Limits {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
};

/// A JSON object whose keys are asked for one by one. What is wrong goes to `faults`, with its JSON path
/// ("sources[1].path[0].azimuth"), and something harmless comes back, so that all faults are found at once.
class JsonReader {
 public:
  /// `value` and `faults` must outlive the reader.
  JsonReader(const nlohmann::json& value, std::string path, std::vector<Fault>& faults);

  [[nodiscard]] bool has(const char* key);
  /// Without a `fallback` the key has to be there.
  double number(const char* key, std::optional<double> fallback, Limits limits = {});
  std::string text(const char* key, std::optional<std::string> fallback);
  bool flag(const char* key, bool fallback);
  Vec3 vector(const char* key, std::optional<Vec3> fallback);
  /// The index of the word in `words`.
  std::size_t choice(const char* key, std::size_t fallback, std::initializer_list<const char*> words);
  JsonReader object(const char* key);
  /// The elements of a list of objects; empty where it is absent.
  std::vector<JsonReader> list(const char* key);
  [[nodiscard]] bool is_text(const char* key);

  /// An empty `key`: the object itself.
  void fault(const std::string& key, std::string what);
  [[nodiscard]] std::string path_of(const std::string& key) const;
  /// Names the keys that nobody asked for.
  void finish();

 private:
  [[nodiscard]] const nlohmann::json* find(const char* key);
  const nlohmann::json* expect(const char* key, bool required);

  const nlohmann::json* value_;
  std::string path_;
  std::vector<Fault>* faults_;
  std::set<std::string, std::less<>> asked_;
};

}  // namespace odas
