// SPDX-License-Identifier: MIT
#include "odas/studio/config_edit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/config/edit.hpp"
#include "odas/config/phrases.hpp"
#include "odas/config/reader.hpp"
#include "odas/studio/config_form.hpp"

namespace odas {

using nlohmann::json;

namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte == 0) throw ConfigError("", "a text cannot hold a zero byte");
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

bool is_key(const std::string& key) {
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0 || c == '*'; };
  if (key.empty() || !is_letter(static_cast<unsigned char>(key.front()))) return false;
  for (const char c : key) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 &&
        std::string_view("*_-").find(c) == std::string_view::npos)
      return false;
  }
  return true;
}

std::string group_text(const json& group) {
  std::string text = "{ ";
  for (const auto& [key, value] : group.items()) {
    if (!is_key(key)) throw ConfigError(key, "is no name of a setting");
    if (!value.is_null()) text += key + " = " + setting_text(value) + "; ";
  }
  return text + "}";
}

std::string list_text(const json& list) {
  const bool of_groups = !list.empty() && list.front().is_object();
  std::string text;
  for (const json& item : list) {
    if (!text.empty()) text += of_groups ? ",\n    " : ", ";
    text += setting_text(item);
  }
  return of_groups ? "(\n    " + text + "\n  )" : "(" + text + ")";
}

std::string number_of(double value) {
  if (!std::isfinite(value)) throw ConfigError("", "a number must be finite");
  std::string text = number_text(value);
  // libconfig takes a number with an exponent for one only if it has a point or a sign.
  if (const std::size_t e = text.find('e'); e != std::string::npos && text.find('.') == std::string::npos) {
    text.insert(e, ".0");
  }
  return text;
}

}  // namespace

std::string setting_text(const json& value) {
  switch (value.type()) {
    case json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
      return value.dump();
    case json::value_t::number_float:
      return number_of(value.get<double>());
    case json::value_t::string:
      return quoted(value.get<std::string>());
    case json::value_t::array:
      return list_text(value);
    case json::value_t::object:
      return group_text(value);
    default:
      throw ConfigError("", "null is no value");
  }
}

std::string with_source(const Document& document, const json& source) {
  std::string text = document.text;
  json interface = json::object();
  for (const auto& [key, value] : source.items()) {
    static constexpr std::array<std::string_view, 5> kOfRaw{"fS", "nChannels", "nBits", "hopSize", "format"};
    if (std::find(kOfRaw.begin(), kOfRaw.end(), key) == kOfRaw.end()) {
      interface[key] = value;
    } else if (!value.is_null()) {
      text = with_setting(text, "raw", key, setting_text(value));
    }
  }
  return with_setting(text, "raw", "interface", setting_text(interface));
}

namespace {

/// "general.mics[0].mu": its parts, list indices as numbers.
std::vector<json> steps_of(const std::string& path) {
  std::vector<json> steps;
  std::string word;
  const auto take = [&](bool is_index) {
    if (word.empty()) throw ConfigError(path, "is no path of a setting");
    if (is_index && (word.size() > 6 || word.find_first_not_of("0123456789") != std::string::npos)) {
      throw ConfigError(path, "an item is named by a number, from 0");
    }
    steps.push_back(is_index ? json(std::stoul(word)) : json(word));
    word.clear();
  };
  bool after_index = false;
  for (const char c : path) {
    if (c == '.' || c == '[') {
      if (!std::exchange(after_index, false)) take(false);
    } else if (c == ']') {
      take(true);
      after_index = true;
    } else {
      word += c;
    }
  }
  if (!after_index) take(false);
  return steps;
}

/// Puts the value where the steps from `at` on lead to, within `place`.
void put(json& place, const std::vector<json>& steps, std::size_t at, const json& value,
         const std::string& path) {
  const bool is_last = at + 1 == steps.size();
  if (steps[at].is_string()) {
    if (place.is_null()) place = json::object();
    if (!place.is_object()) throw ConfigError(path, "leads into what is no group");
    const auto key = steps[at].get<std::string>();
    if (!is_last) return put(place[key], steps, at + 1, value, path);
    if (value.is_null()) {
      place.erase(key);
    } else {
      place[key] = value;
    }
    return;
  }
  if (place.is_null()) place = json::array();
  const auto index = steps[at].get<std::size_t>();
  if (!place.is_array() || index > place.size()) throw ConfigError(path, "there is no such item");
  if (is_last && value.is_null()) {
    if (index < place.size()) place.erase(index);
    return;
  }
  if (index == place.size()) place.push_back(nullptr);
  if (is_last) {
    place[index] = value;
  } else {
    put(place[index], steps, at + 1, value, path);
  }
}

}  // namespace

std::string with_changes(std::string text, const std::string& name, const json& changes) {
  for (const json& change : changes) {
    const auto path = change.at("path").get<std::string>();
    const json& value = change.at("value");
    const std::vector<json> steps = steps_of(path);
    if (steps.size() < 2 || !steps[1].is_string()) throw ConfigError(path, "is no setting of a section");
    const auto section = steps[0].get<std::string>(), key = steps[1].get<std::string>();
    if (!is_key(section) || !is_key(key)) throw ConfigError(path, "is no name of a setting");
    json whole = value;
    if (steps.size() > 2) {
      LoadedConfiguration loaded = read_configuration_text(text, name);
      whole = written_value(loaded, section, key);
      put(whole, steps, 2, value, path);
    }
    text = whole.is_null() ? without_setting(text, section, key)
                           : with_setting(text, section, key, setting_text(whole));
  }
  return text;
}

}  // namespace odas
