// SPDX-License-Identifier: MIT
#include "odas/studio/take.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/io/voices_sink.hpp"
#include "odas/studio/own_file.hpp"

namespace odas {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStepOfWay = 0.1;       // s
constexpr std::size_t kFirstSteps = 10;  // of the way between two writings of the JSON, at least

double rounded(double value) { return std::round(value * 1000) / 1000; }

std::string name_of(const TakeHead& head) {
  std::string name = compact_time(head.start);
  if (head.stream == AudioStream::raw) return name + "_raw";
  name += "_source_" + std::to_string(head.track);
  return head.stream == AudioStream::postfiltered ? name + "_postfiltered" : name;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json to_json(const Transcript& transcript) {
  return {{"from", rounded(transcript.from_s)}, {"to", rounded(transcript.to_s)}, {"text", transcript.text}};
}

}  // namespace

Take::Take(const std::filesystem::path& folder, TakeHead head)
    : head_(std::move(head)),
      wav_path_(free_name(folder, name_of(head_), ".wav")),
      wav_(std::make_unique<WavWriter>(wav_path_, head_.format)) {
  if (IoStatus status = tell(); !status.ok()) {
    static_cast<void>(wav_->close().ok());
    std::error_code ignored;
    std::filesystem::remove(wav_path_, ignored);
    throw IoError(status.what());
  }
}

IoStatus Take::write(std::span<const char> frames) {
  frames_ += frames.size() / (head_.format.channels * static_cast<std::size_t>(head_.format.bits) / 8);
  return wav_->write(frames);
}

IoStatus Take::write_silence(std::size_t frames) {
  gaps_.emplace_back(seconds(), static_cast<double>(frames) / head_.format.sample_rate);
  const std::size_t frame = head_.format.channels * static_cast<std::size_t>(head_.format.bits) / 8;
  const std::vector<char> silence(std::min<std::size_t>(frames, 4096) * frame);
  while (frames > 0) {
    const std::size_t now = std::min<std::size_t>(frames, 4096);
    if (IoStatus status = write(std::span(silence).first(now * frame)); !status.ok()) return status;
    frames -= now;
  }
  return {};
}

void Take::steer(double time, Vec3 direction) {
  if (way_.empty() || time - way_.back().first >= kStepOfWay) way_.emplace_back(time, direction);
}

void Take::add(Transcript transcript) {
  transcripts_.push_back(std::move(transcript));
  due_ = 0;
}

IoStatus Take::set_label(std::string label) {
  label_ = std::move(label);
  return tell();
}

double Take::seconds() const noexcept { return static_cast<double>(frames_) / head_.format.sample_rate; }

IoStatus Take::flush() {
  if (IoStatus status = wav_->flush(); !status.ok()) return status;
  // The longer the way, the rarer it is written anew; the length of the sound is in the WAV itself.
  return way_.size() >= due_ ? tell() : IoStatus();
}

IoStatus Take::close() {
  IoStatus closed = wav_->close();
  IoStatus told = tell();
  return closed.ok() ? told : closed;
}

IoStatus Take::tell() {
  Vec3 sum{};
  Json way = Json::array(), gaps = Json::array(), transcript = Json::array();
  for (const auto& [time, u] : way_) {
    sum = sum + u;
    way.push_back({rounded(time), rounded(static_cast<double>(azimuth_deg(u))),
                   rounded(static_cast<double>(elevation_deg(u)))});
  }
  const Vec3 mean = normalized(sum);
  for (const auto& [begin, length] : gaps_) gaps.push_back({rounded(begin), rounded(length)});
  for (const Transcript& said : transcripts_) transcript.push_back(to_json(said));
  due_ = way_.size() + std::max(kFirstSteps, way_.size() / 4);
  const bool raw = head_.stream == AudioStream::raw;
  Json content{{"made_by", kMaker},
               {"file", name()},
               {"kind", raw ? "raw" : "track"},
               {"stream", odas::name_of(head_.stream)},
               {"label", label_},
               {"fS", head_.format.sample_rate},
               {"channels", head_.format.channels},
               {"bits", head_.format.bits},
               {"start", rounded(head_.start_s)},
               {"utc", iso_time(head_.start)},
               {"seconds", rounded(seconds())},
               {"config", head_.config_name},
               {"config_hash", head_.config_hash},
               {"gaps", gaps}};
  if (!raw) {
    content["id"] = head_.track;
    content["tag"] = head_.tag;
    content["direction"] = {mean.x, mean.y, mean.z};
    content["azimuth"] = rounded(static_cast<double>(azimuth_deg(mean)));
    content["elevation"] = rounded(static_cast<double>(elevation_deg(mean)));
    content["directions"] = way;
    content["transcript"] = transcript;
  }
  return write_whole(std::filesystem::path(wav_path_).replace_extension(".json"), text_of(content));
}

IoStatus add_transcript(const std::filesystem::path& json_file, const Transcript& transcript) {
  std::ifstream in(json_file, std::ios::binary);
  Json content = Json::parse(in, nullptr, false);
  if (!content.is_object() || content.value("made_by", "") != Take::kMaker) return {};
  content["transcript"].push_back(to_json(transcript));
  return write_whole(json_file, text_of(content));
}

}  // namespace odas
