// SPDX-License-Identifier: MIT
#include "odas/io/stream_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

namespace odas {
namespace {

using nlohmann::json;

constexpr std::size_t kMostSlots = 1024;  // a row says its slot itself: nobody may ask for a world of them
constexpr double kLargest = 1e30;         // a float holds it

/// ODAS prints what is no number as "nan" or "inf", which JSON does not know. Only called where it is no
/// JSON.
std::string without_nan(std::string_view text) {
  static constexpr std::array<std::string_view, 4> kWords{": nan", ": -nan", ": inf", ": -inf"};
  std::string out;
  while (!text.empty()) {
    const auto word = std::find_if(kWords.begin(), kWords.end(),
                                   [&](std::string_view candidate) { return text.starts_with(candidate); });
    const std::size_t skip = word != kWords.end() ? word->size() : 1;
    out += word != kWords.end() ? std::string_view(": 0.0") : text.substr(0, 1);
    text.remove_prefix(skip);
  }
  return out;
}

float number_in(const json& row, const char* key) {
  const auto found = row.find(key);
  if (found == row.end() || !found->is_number()) return 0;
  const auto value = found->get<double>();
  return std::abs(value) < kLargest ? static_cast<float>(value) : 0;
}

std::string text_in(const json& row, const char* key) {
  const auto found = row.find(key);
  return found != row.end() && found->is_string() ? found->get<std::string>() : "";
}

std::optional<std::uint64_t> count_in(const json& row, const char* key) {
  const auto found = row.find(key);
  if (found == row.end() || !found->is_number_unsigned()) return std::nullopt;
  return found->get<std::uint64_t>();
}

Category category_of(std::string_view name) {
  if (name == "speech") return Category::speech;
  return name == "nonspeech" ? Category::nonspeech : Category::undefined;
}

Vec3 direction_in(const json& row) { return {number_in(row, "x"), number_in(row, "y"), number_in(row, "z")}; }

StreamRecord refused(std::string fault) {
  StreamRecord record;
  record.fault = std::move(fault);
  return record;
}

std::optional<StreamKind> kind_of(const json& row) {
  if (!row.is_object()) return std::nullopt;
  if (row.contains("activity")) return StreamKind::tracks;  // it may have an E, too
  if (row.contains("E")) return StreamKind::potentials;
  if (row.contains("category") || row.contains("class")) return StreamKind::categories;
  return std::nullopt;
}

/// False: the row is none of this record.
bool add_row(const json& row, std::size_t index, StreamRecord& record) {
  if (kind_of(row) != record.kind) return false;
  if (record.kind == StreamKind::potentials) {
    record.potentials.push_back({direction_in(row), number_in(row, "E")});
    return true;
  }
  const std::size_t slot = count_in(row, "slot").value_or(index);
  if (slot >= kMostSlots) return false;
  if (record.tracks.size() <= slot) record.tracks.resize(slot + 1);
  Track& track = record.tracks[slot];
  track.id = count_in(row, "id").value_or(0);
  track.tag = std::string_view(text_in(row, "tag"));
  track.direction = direction_in(row);
  track.activity = number_in(row, "activity");
  track.category = category_of(text_in(row, row.contains("category") ? "category" : "class"));
  return true;
}

}  // namespace

StreamRecord read_stream_record(std::string_view text, StreamKind expected) {
  json content = json::parse(text, nullptr, false);
  if (content.is_discarded()) content = json::parse(without_nan(text), nullptr, false);
  if (content.is_discarded()) return refused("is no JSON");
  if (!content.is_object()) return refused("is no JSON object");
  const std::optional<std::uint64_t> time = count_in(content, "timeStamp");
  if (!time) return refused("has no \"timeStamp\"");
  const auto rows = content.find("src");
  if (rows == content.end() || !rows->is_array()) return refused("has no list \"src\"");

  StreamRecord record;
  record.time = *time;
  record.kind = expected;
  if (!rows->empty()) {
    const std::optional<StreamKind> kind = kind_of(rows->front());
    if (!kind) return refused("has rows that are no track, potential or category");
    record.kind = *kind;
  }
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if (!add_row((*rows)[i], i, record)) return refused("has rows of more than one kind");
  }
  record.is_line = content.contains("utc") && text.find('\n') == std::string_view::npos;
  return record;
}

}  // namespace odas
