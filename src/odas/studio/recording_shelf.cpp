// SPDX-License-Identifier: MIT
#include "odas/studio/recording_shelf.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <sndfile.hh>

#include "odas/io/wav_writer.hpp"
#include "odas/studio/own_file.hpp"
#include "odas/studio/rpc.hpp"
#include "odas/studio/take.hpp"

namespace odas {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::uintmax_t kLongestJson = std::uintmax_t{64} << 20;
constexpr std::size_t kMostPeaks = 32;  // that are kept

std::uintmax_t size_of(const fs::path& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

json read_own(const fs::path& file) {
  if (size_of(file) > kLongestJson) return nullptr;
  std::ifstream in(file, std::ios::binary);
  json content = json::parse(in, nullptr, false);
  const fs::path wav = fs::path(file).replace_extension(".wav");
  const bool ours = content.is_object() && content.value("made_by", json()) == Take::kMaker &&
                    content.value("file", json()) == wav.filename().string();
  return ours ? content : json();
}

std::string transcript_of(const json& content) {
  std::string all;
  for (const json& said : content.value("transcript", json::array())) {
    if (!all.empty()) all += ' ';
    all += said.value("text", "");
  }
  return all;
}

json entry_of(const json& content, const fs::path& wav) {
  const std::uintmax_t bytes = size_of(wav);
  // The file knows its length better than the JSON of a recording that was killed.
  const bool raw = content.value("kind", "") == "raw";
  const std::uintmax_t frame =
      std::max<std::uintmax_t>(1, content.value("channels", 1U) * (content.value("bits", 16U) / 8));
  const std::uintmax_t sound = bytes > kWavHeaderSize ? bytes - kWavHeaderSize : 0;
  json entry{{"name", wav.filename().string()},
             {"kind", content.value("kind", "")},
             {"stream", content.value("stream", "")},
             {"seconds", static_cast<double>(sound / frame) / std::max(1, content.value("fS", 1))},
             {"bytes", bytes},
             {"start", content.value("utc", "")},
             {"label", content.value("label", "")},
             {"transcript", transcript_of(content)}};
  if (!raw) {
    entry["track"] = content.value("id", 0U);
    entry["tag"] = content.value("tag", "");
    entry["direction"] = content.value("direction", json::array());
  }
  return entry;
}

}  // namespace

const json& RecordingShelf::read(const fs::path& json_file) {
  std::error_code error;
  Known& known = known_[json_file.filename().string()];
  const auto time = fs::last_write_time(json_file, error);
  const std::uintmax_t size = size_of(json_file);
  if (known.size != size || known.time != time || known.content.is_null()) {
    try {
      known = {size, time, is_file(json_file) ? read_own(json_file) : json()};
    } catch (const json::exception&) { known = {size, time, nullptr}; }
  }
  return known.content;
}

json RecordingShelf::list() {
  std::vector<json> entries;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(folder_, error)) {
    const fs::path path = file.path();
    if (path.extension() != ".json" || !is_plain_name(path.filename().string())) continue;
    const fs::path wav = fs::path(path).replace_extension(".wav");
    if (!is_file(wav)) continue;
    try {
      if (const json& content = read(path); !content.is_null()) entries.push_back(entry_of(content, wav));
    } catch (const json::exception&) { continue; }  // somebody has edited it: it is none of ours any more
  }
  std::sort(entries.begin(), entries.end(), [](const json& a, const json& b) {
    return std::pair(a["start"], a["name"]) > std::pair(b["start"], b["name"]);
  });
  return entries;
}

std::optional<fs::path> RecordingShelf::find(const std::string& name) {
  if (!is_plain_name(name)) return std::nullopt;
  const fs::path path = folder_ / name;
  if (path.extension() != ".wav" && path.extension() != ".json") return std::nullopt;
  const fs::path wav = fs::path(path).replace_extension(".wav");
  if (!is_file(path) || !is_file(wav) || read(fs::path(path).replace_extension(".json")).is_null()) {
    return std::nullopt;
  }
  return path;
}

fs::path RecordingShelf::must_find(const std::string& name) {
  const auto found = find(name);
  if (!found || found->extension() != ".wav") {
    throw RpcError("not_found", "there is no recording '" + name + "' that a Studio made");
  }
  return *found;
}

void RecordingShelf::rename(const std::string& name, const std::string& label) {
  const fs::path file = must_find(name).replace_extension(".json");
  json content = read(file);
  content["label"] = label;
  if (IoStatus status =
          write_whole(file, content.dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
      !status.ok()) {
    throw RpcError("failed", status.what());
  }
}

void RecordingShelf::remove(const std::string& name) {
  const fs::path file = must_find(name);
  std::error_code error;
  fs::remove(file, error);
  if (error) throw RpcError("failed", "cannot delete " + file.string() + ": " + error.message());
  fs::remove(fs::path(file).replace_extension(".json"), error);
  known_.erase(fs::path(name).replace_extension(".json").string());
}

json RecordingShelf::peaks(const std::string& name, std::size_t columns) {
  const fs::path file = must_find(name);
  const std::string key = name + "/" + std::to_string(size_of(file)) + "/" + std::to_string(columns);
  for (const auto& [known, value] : peaks_) {
    if (known == key) return value;
  }
  SndfileHandle sound(file.string());
  if (sound.error() != 0) throw RpcError("failed", file.string() + ": " + sound.strError());
  const auto frames = static_cast<std::size_t>(std::max<sf_count_t>(sound.frames(), 0));
  const auto channels = static_cast<std::size_t>(std::max(sound.channels(), 1));
  std::vector<float> low(columns, 0), high(columns, 0);
  std::vector<float> piece;
  for (std::size_t column = 0; column < columns && frames > 0; ++column) {
    const std::size_t begin = frames * column / columns, end = frames * (column + 1) / columns;
    std::size_t left = std::max<std::size_t>(end, begin + 1) - begin;
    // Columns of less than a frame show the frame.
    if (columns > frames) sound.seek(static_cast<sf_count_t>(begin), SEEK_SET);
    bool first = true;
    while (left > 0) {
      piece.resize(std::min<std::size_t>(left, 16384) * channels);
      const auto got = static_cast<std::size_t>(std::max<sf_count_t>(
          sound.readf(piece.data(), static_cast<sf_count_t>(piece.size() / channels)), 0));
      if (got == 0) break;
      const auto [least, most] =
          std::minmax_element(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got * channels));
      low[column] = first ? *least : std::min(low[column], *least);
      high[column] = first ? *most : std::max(high[column], *most);
      first = false;
      left -= got;
    }
  }
  const auto short_numbers = [](const std::vector<float>& values) {
    json list = json::array();
    for (const float x : values) list.push_back(std::round(x * 10000) / 10000.0);
    return list;
  };
  json result{{"min", short_numbers(low)},
              {"max", short_numbers(high)},
              {"seconds", static_cast<double>(frames) / std::max(1, sound.samplerate())},
              {"rate", sound.samplerate()}};
  peaks_.emplace_back(key, result);
  if (peaks_.size() > kMostPeaks) peaks_.pop_front();
  return result;
}

}  // namespace odas
