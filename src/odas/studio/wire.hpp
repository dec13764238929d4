// SPDX-License-Identifier: MIT
// What daemon, page and session files say in the same bytes: docs/protocol.md, "The Studio".
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "odas/studio/hop_listener.hpp"

namespace odas {

/// The voices and microphones that can be heard or kept, by their number in the binary header.
enum class AudioStream : std::uint8_t { separated, postfiltered, raw };
inline constexpr std::size_t kAudioStreams = 3;
/// "separated", "postfiltered", "raw".
[[nodiscard]] const char* name_of(AudioStream stream) noexcept;
/// The audio of a hop: [slot][sample], or of `raw` [mic][sample].
[[nodiscard]] GridView<const float> audio_of(const HopResult& hop, AudioStream stream) noexcept;
/// The gain that the configuration gives a stream; 1 of `raw`.
[[nodiscard]] float gain_of(const StreamInfo& info, AudioStream stream) noexcept;

/// `run` of `hello`, but for `targets`, which is empty.
[[nodiscard]] nlohmann::json run_message(const StreamInfo& info);

/// Appends `H`, the JSON of a hop. Levels are those of the separated voices, or, where nobody makes them, of
/// the post-filtered ones, without their gain.
void append_hop(std::string& to, const HopResult& hop, bool with_potentials = true);

/// `2026-01-31T12:00:00.125Z`
[[nodiscard]] std::string iso_time(std::chrono::system_clock::time_point instant);

/// The first 24 bytes of a binary message of sound.
struct AudioHeader {
  static constexpr std::size_t kSize = 24;
  static constexpr std::uint16_t kGap = 1, kLast = 2;
  AudioStream stream = AudioStream::separated;
  std::uint32_t track = 0;  // of raw: the microphone, from 1
  std::uint64_t index = 0;  // of the first sample since the start of the run
  std::uint32_t rate = 16000;
  std::uint16_t samples = 0;
  std::uint16_t flags = 0;
};
void append_header(std::vector<char>& to, const AudioHeader& header);

}  // namespace odas
