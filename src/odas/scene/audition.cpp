// SPDX-License-Identifier: MIT
#include "odas/scene/audition.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/scene/heard_voices.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The objects of a file, one behind the other, lines or not. Stops where the file was cut.
void for_each_object(const fs::path& file, const std::function<void(const json&)>& visit) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw IoError("cannot read " + file.string());
  const auto between = [](int c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\0'; };
  while (true) {
    while (between(in.peek())) in.get();
    if (in.peek() == std::ifstream::traits_type::eof()) return;
    json object;
    try {
      in >> object;
    } catch (const json::parse_error&) { return; }
    try {
      visit(object);
    } catch (const json::exception& error) {
      throw IoError(file.string() + " is not a system's output: " + error.what());
    }
  }
}

Direction heard_direction(const json& source) {
  return {source.at("x").get<double>(), source.at("y").get<double>(), source.at("z").get<double>()};
}

/// From 0; none for stamps before the beginning.
std::optional<std::size_t> hop_of(const json& object) {
  const auto stamp = object.at("timeStamp").get<long>();
  if (stamp < 1) return std::nullopt;
  return static_cast<std::size_t>(stamp - 1);
}

std::optional<HeardPotential> strongest_of(const json& object) {
  const auto hop = hop_of(object);
  const json* strongest = nullptr;
  for (const json& source : object.at("src")) {
    if (strongest == nullptr || source.at("E").get<double>() > strongest->at("E").get<double>()) {
      strongest = &source;
    }
  }
  if (!hop || strongest == nullptr) return std::nullopt;
  return HeardPotential{*hop, heard_direction(*strongest)};
}

struct HeardTracks {
  std::vector<HeardHop> hops;
  std::size_t slots = 0;     // as far as they were seen
  std::size_t duration = 0;  // hops
};

HeardTracks read_tracks(const fs::path& file) {
  HeardTracks tracks;
  for_each_object(file, [&](const json& object) {
    const auto hop = hop_of(object);
    if (!hop) return;
    HeardHop heard{*hop, {}};
    std::size_t place = 0;
    for (const json& source : object.at("src")) {
      const std::size_t slot = source.value("slot", place);
      ++place;
      tracks.slots = std::max(tracks.slots, slot + 1);
      const auto id = source.at("id").get<std::uint64_t>();
      if (id != 0) heard.tracks.push_back({slot, id, heard_direction(source)});
    }
    tracks.duration = std::max(tracks.duration, *hop + 1);
    tracks.hops.push_back(std::move(heard));
  });
  return tracks;
}

std::optional<fs::path> first_of(const fs::path& folder, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return std::nullopt;
}

}  // namespace

Audition read_audition(const fs::path& folder, const KnownScene& scene) {
  const auto tracks_file = first_of(folder, {"tracks.json", "tracks.jsonl"});
  if (!tracks_file) {
    throw IoError("there is nothing to score in " + folder.string() +
                  ": neither tracks.json nor tracks.jsonl, as `odas run -o` writes them");
  }
  Audition audition;
  HeardTracks tracks = read_tracks(*tracks_file);
  audition.tracks = std::move(tracks.hops);
  if (const auto file = first_of(folder, {"pots.json", "potentials.jsonl"})) {
    audition.potentials.emplace();
    for_each_object(*file, [&](const json& object) {
      if (const auto potential = strongest_of(object)) audition.potentials->push_back(*potential);
    });
  }
  const RawLayout layout{scene.hop_size, tracks.slots, tracks.duration};
  if (const auto file = first_of(folder, {"separated.raw", "voices"})) {
    audition.separated = file->extension() == ".raw" ? raw_voices(*file, layout) : voices_by_id(*file, scene);
  }
  if (const auto file = first_of(folder, {"postfiltered.raw"})) {
    audition.postfiltered = raw_voices(*file, layout);
  }
  return audition;
}

}  // namespace odas
