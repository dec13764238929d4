// SPDX-License-Identifier: MIT
#include "odas/studio/session_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace odas {
namespace {

using nlohmann::json;

constexpr std::string_view kAudio = "audio/";

double seconds(std::uint64_t from_ns, std::uint64_t to_ns) {
  return to_ns > from_ns ? static_cast<double>(to_ns - from_ns) / 1e9 : 0;
}

void note_audio(const std::string& topic, std::vector<std::string>& streams) {
  if (!topic.starts_with(kAudio)) return;
  const std::string stream = topic.substr(kAudio.size());
  if (std::find(streams.begin(), streams.end(), stream) == streams.end()) streams.push_back(stream);
}

}  // namespace

SessionInfo SessionReader::info() const {
  McapReader reader(file_);
  SessionInfo info;
  info.ours = reader.profile() == "odas";
  if (const auto all = reader.statistics()) {
    for (const McapChannel& channel : reader.summary_channels()) note_audio(channel.topic, info.audio);
    // Of sound the times are earlier by its delay; the first message is the run's.
    const auto first = reader.next();
    info.start_ns = first ? first->time : all->begin_ns;
    info.seconds = seconds(info.start_ns, all->end_ns);
    return info;
  }
  std::uint64_t end = 0;
  while (const auto message = reader.next()) {
    note_audio(message->channel->topic, info.audio);
    if (info.start_ns == 0) info.start_ns = message->time;
    end = std::max(end, message->time);
  }
  info.seconds = seconds(info.start_ns, end);
  info.fault = fmt::format("{} after {:.1f} s", reader.fault(), info.seconds);
  return info;
}

std::string SessionReader::read(const Visitor& visitor) const {
  McapReader reader(file_);
  std::uint64_t first = 0, last = 0;
  while (const auto message = reader.next()) {
    if (first == 0) first = message->time;
    last = std::max(last, message->time);
    const std::string& topic = message->channel->topic;
    if (topic.starts_with(kAudio)) {
      if (visitor.audio) visitor.audio(topic.substr(kAudio.size()), message->data);
      continue;
    }
    const bool is_wanted = topic == "hops"  ? static_cast<bool>(visitor.hop)
                           : topic == "run" ? static_cast<bool>(visitor.run)
                                            : static_cast<bool>(visitor.text);
    if (!is_wanted) continue;
    try {
      const json content = json::parse(message->data.begin(), message->data.end());
      if (topic == "hops") {
        visitor.hop(content, message->time);
      } else if (topic == "run") {
        visitor.run(content);
      } else {
        visitor.text(topic, content);
      }
    } catch (const json::exception&) { continue; }  // damaged: the check sum of its chunk says so
  }
  return reader.fault().empty() ? "" : fmt::format("{} after {:.1f} s", reader.fault(), seconds(first, last));
}

}  // namespace odas
