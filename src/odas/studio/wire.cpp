// SPDX-License-Identifier: MIT
#include "odas/studio/wire.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include "odas/studio/little_endian.hpp"

namespace odas {
namespace {

constexpr double kInaudible = -120;  // dB: below it nobody hears anything

template <class Value>
void put(std::string& to, Value value) {
  fmt::format_to(std::back_inserter(to), "{}", value);
}

/// JSON knows no number that is none.
void put_number(std::string& to, float value, int decimals) {
  fmt::format_to(std::back_inserter(to), "{:.{}f}", std::isfinite(value) ? value : 0.0F, decimals);
}

void put_direction(std::string& to, Vec3 u) {
  for (const float x : {u.x, u.y, u.z}) {
    put_number(to, x, 4);
    to += ',';
  }
}

double level_db(std::span<const float> voice) {
  double sum = 0;
  for (const float x : voice) sum += static_cast<double>(x) * static_cast<double>(x);
  const double db = 10 * std::log10(sum / static_cast<double>(voice.size()));
  return db > kInaudible ? db : kInaudible;
}

void put_track(std::string& to, std::size_t slot, const Track& track, GridView<const float> voices) {
  to += '[';
  put(to, slot);
  to += ',';
  put(to, track.id);
  to += ',';
  put_direction(to, track.direction);
  put_number(to, track.activity, 3);
  to += ',';
  if (slot < voices.rows() && voices.cols() > 0) {
    put_number(to, static_cast<float>(level_db(voices[slot])), 1);
  } else {
    to += "null";
  }
  to += ',';
  put(to, static_cast<int>(track.category));
  if (track.tag.view() != "dynamic") {
    to += ',';
    to += nlohmann::json(track.tag.view()).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  to += ']';
}

nlohmann::json vector_of(Vec3 v) { return nlohmann::json::array({v.x, v.y, v.z}); }

}  // namespace

const char* name_of(AudioStream stream) noexcept {
  static constexpr std::array<const char*, kAudioStreams> kNames{"separated", "postfiltered", "raw"};
  return kNames[static_cast<std::size_t>(stream)];
}

GridView<const float> audio_of(const HopResult& hop, AudioStream stream) noexcept {
  return stream == AudioStream::separated      ? hop.separated
         : stream == AudioStream::postfiltered ? hop.postfiltered
                                               : hop.mics;
}

float gain_of(const StreamInfo& info, AudioStream stream) noexcept {
  return stream == AudioStream::separated      ? info.separated_gain
         : stream == AudioStream::postfiltered ? info.postfiltered_gain
                                               : 1.0F;
}

std::string iso_time(std::chrono::system_clock::time_point instant) {
  const auto ms = std::chrono::floor<std::chrono::milliseconds>(instant);
  const auto s = std::chrono::floor<std::chrono::seconds>(instant);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(s)),
                     (ms - s).count());
}

nlohmann::json run_message(const StreamInfo& info) {
  using nlohmann::json;
  static constexpr std::array<const char*, 3> kKinds{"live", "recording", "odas"};
  json mics = json::array(), grid = json::array();
  for (std::size_t m = 0; m < info.mics.size(); ++m) {
    const MicConfig& mic = info.mics[m];
    mics.push_back({{"position", mic.mu},
                    {"direction", mic.direction},
                    {"channel", m < info.channels.size() ? info.channels[m] : static_cast<int>(m) + 1}});
  }
  for (const Vec3 u : info.power_grid) grid.push_back(vector_of(u));
  return {{"id", info.run},
          {"name", info.name},
          {"source", info.source},
          {"kind", kKinds[static_cast<std::size_t>(info.kind)]},
          {"rate", info.sample_rate},
          {"hop", info.hop_size},
          {"slots", info.slots},
          {"potentials", info.potentials},
          {"lookback", info.lookback_s},
          {"voice_delay", info.voice_delay_s},
          {"start", iso_time(info.start)},
          {"config_hash", info.config_hash},
          {"mics", mics},
          {"power_grid", grid},
          {"targets", json::array()}};
}

void append_hop(std::string& to, const HopResult& hop, bool with_potentials) {
  to += "{\"t\":";
  put(to, hop.time);
  to += ",\"tracks\":[";
  const GridView<const float> voices = hop.separated.empty() ? hop.postfiltered : hop.separated;
  bool first = true;
  for (std::size_t slot = 0; slot < hop.tracks.size(); ++slot) {
    if (hop.tracks[slot].id == 0) continue;
    if (!std::exchange(first, false)) to += ',';
    put_track(to, slot, hop.tracks[slot], voices);
  }
  to += ']';
  if (with_potentials) {
    to += ",\"potentials\":[";
    first = true;
    for (const Potential& potential : hop.potentials) {
      to += std::exchange(first, false) ? "[" : ",[";
      put_direction(to, potential.direction);
      put_number(to, potential.energy, 4);
      to += ']';
    }
    to += ']';
  }
  to += '}';
}

void append_header(std::vector<char>& to, const AudioHeader& header) {
  to.insert(to.end(), {1, 1, 1, static_cast<char>(header.stream)});
  put_le(to, header.track);
  put_le(to, header.index);
  put_le(to, header.rate);
  put_le(to, header.samples);
  put_le(to, header.flags);
}

}  // namespace odas
