// SPDX-License-Identifier: MIT
#include "odas/io/voices_sink.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

namespace odas {
namespace {

using std::chrono::system_clock;

constexpr double kStepOfWay = 0.1;  // s

system_clock::time_point at(system_clock::time_point start, double seconds) {
  return start + std::chrono::duration_cast<system_clock::duration>(std::chrono::duration<double>(seconds));
}

VoiceRecorder::Format format_of(const PipelineConfig& config, float gain, system_clock::time_point start) {
  const GeneralConfig& general = config.general;
  VoiceRecorder::Format format;
  format.sample_rate = general.samplerate.mu;
  format.hop_seconds = static_cast<double>(general.size.hop_size) / general.samplerate.mu;
  format.delay_s = voice_delay_s(config);
  format.gain = gain;
  format.file_name = [start](std::uint64_t id, double start_s) {
    return compact_time(at(start, start_s)) + "_source_" + std::to_string(id) + ".wav";
  };
  return format;
}

std::string iso_time(system_clock::time_point instant) {
  const auto ms = std::chrono::floor<std::chrono::milliseconds>(instant);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(system_clock::to_time_t(ms)),
                     (ms.time_since_epoch() % std::chrono::seconds(1)).count());
}

double rounded(double value) { return std::round(value * 1000) / 1000; }

}  // namespace

std::string compact_time(system_clock::time_point instant) {
  const auto ms = std::chrono::floor<std::chrono::milliseconds>(instant);
  return fmt::format("{:%Y%m%dT%H%M%S}.{:03}Z", fmt::gmtime(system_clock::to_time_t(instant)),
                     ms.time_since_epoch().count() % 1000);
}

VoicesSink::VoicesSink(const std::filesystem::path& folder, AudioSink::Stream stream,
                       const PipelineConfig& config, float gain, system_clock::time_point start)
    : folder_(folder),
      stream_(stream),
      sample_rate_(config.general.samplerate.mu),
      hop_seconds_(static_cast<double>(config.general.size.hop_size) / config.general.samplerate.mu),
      start_(start),
      recorder_(folder, format_of(config, gain, start)) {}

std::string VoicesSink::name() const {
  return std::string(stream_ == AudioSink::Stream::separated ? "sss.separated" : "sss.postfiltered") + " (" +
         folder_.string() + ")";
}

Wanted VoicesSink::wanted() const noexcept {
  const bool separated = stream_ == AudioSink::Stream::separated;
  return {.potentials = false, .tracks = true, .separated = separated, .postfiltered = !separated};
}

IoStatus VoicesSink::write(const HopResult& hop) {
  IoStatus status = recorder_.add(hop.time, hop.tracks,
                                  stream_ == AudioSink::Stream::separated ? hop.separated : hop.postfiltered);
  follow(hop);
  return status;
}

void VoicesSink::follow(const HopResult& hop) {
  stories_.resize(recorder_.voices().size());
  const double now = static_cast<double>(hop.time - 1) * hop_seconds_;
  for (std::size_t slot = 0; slot < hop.tracks.size(); ++slot) {
    const auto voice = recorder_.voice_of(slot);
    if (!voice) continue;
    Story& story = stories_[*voice];
    const Track& track = hop.tracks[slot];
    story.written = false;
    story.tag = track.tag.view();
    if (story.way.empty() || now - story.way.back().first >= kStepOfWay - hop_seconds_ / 2) {
      story.way.emplace_back(now, track.direction);
    }
  }
}

IoStatus VoicesSink::flush() {
  if (IoStatus status = recorder_.flush(); !status.ok()) return status;
  return tell_stories();
}

IoStatus VoicesSink::close() {
  IoStatus closed = recorder_.close();
  IoStatus told = tell_stories();
  return closed.ok() ? told : closed;
}

IoStatus VoicesSink::tell_stories() {
  for (std::size_t v = 0; v < stories_.size();) {
    Story& story = stories_[v];
    const bool goes_on = recorder_.is_open(v);
    if (!goes_on || story.way.size() >= story.due) {
      if (IoStatus status = tell(recorder_.voices()[v], story); !status.ok()) return status;
      // The longer the way, the rarer it is written.
      story.due = story.way.size() + std::max<std::size_t>(10, story.way.size() / 4);
    }
    if (goes_on) {
      ++v;
    } else {
      recorder_.forget(v);
      stories_.erase(stories_.begin() + static_cast<std::ptrdiff_t>(v));
    }
  }
  return {};
}

IoStatus VoicesSink::tell(const Voice& voice, Story& story) const {
  if (story.written || story.way.empty()) return {};
  Vec3 sum{};
  nlohmann::ordered_json way = nlohmann::ordered_json::array();
  for (const auto& [time, direction] : story.way) {
    sum = sum + direction;
    way.push_back({rounded(time), rounded(static_cast<double>(azimuth_deg(direction))),
                   rounded(static_cast<double>(elevation_deg(direction)))});
  }
  const nlohmann::ordered_json content{
      {"id", voice.id},
      {"tag", story.tag},
      {"file", voice.file},
      {"fS", sample_rate_},
      {"start", rounded(voice.start_s)},
      {"utc", iso_time(at(start_, voice.start_s))},
      {"seconds", rounded(voice.seconds)},
      {"azimuth", rounded(static_cast<double>(azimuth_deg(sum)))},
      {"elevation", rounded(static_cast<double>(elevation_deg(sum)))},
      {"directions", way},
  };
  const std::filesystem::path file = folder_ / std::filesystem::path(voice.file).replace_extension(".json");
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out << content.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  out.close();
  if (!out) return IoStatus::failed("cannot write " + file.string() + ": is the disk full?");
  story.written = true;
  return {};
}

}  // namespace odas
