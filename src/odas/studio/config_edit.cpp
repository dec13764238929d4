// SPDX-License-Identifier: MIT
#include "odas/studio/config_edit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/config/edit.hpp"
#include "odas/config/phrases.hpp"
#include "odas/config/reader.hpp"
#include "odas/studio/config_values.hpp"

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

}  // namespace odas
