// SPDX-License-Identifier: MIT
#include "odas/scene/json_reader.hpp"

#include <cmath>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

namespace odas {
namespace {

const nlohmann::json& nothing() {
  static const nlohmann::json empty = nlohmann::json::object();
  return empty;
}

std::string plain(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string allowed(Limits limits) {
  const bool low = limits.low > Limits{}.low;
  const bool high = limits.high < Limits{}.high;
  if (low && high) return "from " + plain(limits.low) + " to " + plain(limits.high);
  return low ? "at least " + plain(limits.low) : "at most " + plain(limits.high);
}

}  // namespace

JsonReader::JsonReader(const nlohmann::json& value, std::string path, std::vector<Fault>& faults)
    : value_(&value), path_(std::move(path)), faults_(&faults) {
  if (value.is_object()) return;
  faults.push_back({Fault::Severity::error, path_, "has to be an object { ... }", {}, 0});
  value_ = &nothing();
}

std::string JsonReader::path_of(const std::string& key) const {
  if (path_.empty() || key.empty()) return path_ + key;
  return path_ + "." + key;
}

void JsonReader::fault(const std::string& key, std::string what) {
  faults_->push_back({Fault::Severity::error, path_of(key), std::move(what), {}, 0});
}

const nlohmann::json* JsonReader::find(const char* key) {
  asked_.insert(key);
  const auto at = value_->find(key);
  return at == value_->end() ? nullptr : &*at;
}

const nlohmann::json* JsonReader::expect(const char* key, bool required) {
  const nlohmann::json* value = find(key);
  if (value == nullptr && required) fault(key, "is missing");
  return value;
}

bool JsonReader::has(const char* key) { return find(key) != nullptr; }

bool JsonReader::is_text(const char* key) {
  const nlohmann::json* value = find(key);
  return value != nullptr && value->is_string();
}

double JsonReader::number(const char* key, std::optional<double> fallback, Limits limits) {
  const nlohmann::json* value = expect(key, !fallback);
  const double harmless = fallback.value_or(1);
  if (value == nullptr) return harmless;
  if (!value->is_number()) {
    fault(key, "has to be a number");
    return harmless;
  }
  const double number = value->get<double>();
  if (!std::isfinite(number) || number < limits.low || number > limits.high) {
    fault(key, "is " + value->dump() + "; it has to be " + allowed(limits));
    return harmless;
  }
  return number;
}

std::string JsonReader::text(const char* key, std::optional<std::string> fallback) {
  const nlohmann::json* value = expect(key, !fallback);
  if (value == nullptr) return fallback.value_or("");
  if (!value->is_string() || value->get<std::string>().empty()) {
    fault(key, "has to be a text that is not empty");
    return fallback.value_or("");
  }
  return value->get<std::string>();
}

bool JsonReader::flag(const char* key, bool fallback) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  if (!value->is_boolean()) fault(key, "has to be true or false");
  return value->is_boolean() ? value->get<bool>() : fallback;
}

Vec3 JsonReader::vector(const char* key, std::optional<Vec3> fallback) {
  const nlohmann::json* value = expect(key, !fallback);
  const Vec3 harmless = fallback.value_or(Vec3{0, 0, 1});
  if (value == nullptr) return harmless;
  bool good = value->is_array() && value->size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) {
    good = (*value)[i].is_number() && std::isfinite((*value)[i].get<float>());
  }
  if (!good) {
    fault(key, "has to be three numbers [x, y, z]");
    return harmless;
  }
  return {(*value)[0].get<float>(), (*value)[1].get<float>(), (*value)[2].get<float>()};
}

std::size_t JsonReader::choice(const char* key, std::size_t fallback,
                               std::initializer_list<const char*> words) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  std::size_t index = 0;
  std::string all;
  for (const char* word : words) {
    if (value->is_string() && value->get_ref<const std::string&>() == word) return index;
    all += (index++ == 0 ? "" : ", ") + std::string(word);
  }
  fault(key, "is " + value->dump() + "; it has to be one of " + all);
  return fallback;
}

JsonReader JsonReader::object(const char* key) {
  const nlohmann::json* value = find(key);
  return {value == nullptr ? nothing() : *value, path_of(key), *faults_};
}

std::vector<JsonReader> JsonReader::list(const char* key) {
  std::vector<JsonReader> elements;
  const nlohmann::json* value = find(key);
  if (value == nullptr) return elements;
  if (!value->is_array()) {
    fault(key, "has to be a list [ ... ]");
    return elements;
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    elements.emplace_back((*value)[i], path_of(key) + "[" + std::to_string(i) + "]", *faults_);
  }
  return elements;
}

void JsonReader::finish() {
  for (const auto& item : value_->items()) {
    if (!asked_.contains(item.key())) fault(item.key(), "is not a key of scenes");
  }
}

}  // namespace odas
