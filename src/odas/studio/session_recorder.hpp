// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "odas/studio/mcap_writer.hpp"
#include "odas/studio/wire.hpp"

namespace odas {

/// Keeps a whole session in one file of MCAP: hops, sound, events, transcripts and log, as docs/protocol.md
/// says. What was there at the last `flush` is in the file, whatever happens.
///
/// One thread at a time.
class SessionRecorder {
 public:
  using Streams = std::array<bool, kAudioStreams>;

  /// A new file in the folder, named after the time of day. Throws IoError.
  SessionRecorder(const std::filesystem::path& folder, Streams audio);

  /// A run begins, or is there already: `last` is the hop before the next.
  IoStatus begin(const StreamInfo& info, HopIndex last = 0);
  IoStatus hop(const HopResult& hop);
  /// `topic`: "log", "event" or "transcript"; its time is that of the last hop.
  IoStatus add(const std::string& topic, const nlohmann::json& message);
  IoStatus flush();
  IoStatus close();

  [[nodiscard]] std::string name() const;
  [[nodiscard]] double seconds() const noexcept { return seconds_; }

 private:
  /// Sound of one voice or microphone that waits until there is enough of it for a message.
  struct Packet {
    AudioHeader header;
    std::vector<char> samples;
  };

  void hear(const HopResult& hop, AudioStream stream);
  void put_packet(Packet& packet, std::uint16_t flags);
  void put(std::uint16_t channel, double time_s, std::span<const char> data);
  IoStatus status() { return std::exchange(status_, IoStatus()); }

  McapWriter file_;
  Streams audio_;
  std::optional<StreamInfo> info_;
  HopIndex last_ = 0;
  double seconds_ = 0;
  std::uint16_t run_ = 0, hops_ = 0;
  std::array<std::uint16_t, kAudioStreams> sound_{};
  std::array<std::pair<const char*, std::uint16_t>, 3> texts_{};
  std::array<std::vector<Packet>, kAudioStreams> packets_;  // [stream][slot or microphone]
  std::string text_;
  std::vector<char> bytes_, message_;
  IoStatus status_;
};

}  // namespace odas
