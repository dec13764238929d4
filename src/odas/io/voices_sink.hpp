// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "odas/io/audio_sink.hpp"
#include "odas/io/voice_recorder.hpp"
#include "odas/pipeline/config.hpp"

namespace odas {

/// A folder with a WAV file for each voice, and a JSON file beside it: `type = "voices"`. The names begin
/// with the time of day, so they sort, and nothing is ever overwritten: a talker who comes back gets another
/// file.
///
/// Rate: that of the processing, 16 bits. JSON: docs/protocol.md; brought up to date each second.
class VoicesSink : public Sink {
 public:
  /// Makes the folder. `start`: when the first hop is. Throws IoError.
  VoicesSink(const std::filesystem::path& folder, AudioSink::Stream stream, const PipelineConfig& config,
             float gain, std::chrono::system_clock::time_point start);

  [[nodiscard]] std::string name() const override;
  [[nodiscard]] Wanted wanted() const noexcept override;
  IoStatus write(const HopResult& hop) override;
  IoStatus flush() override;
  IoStatus close() override;
  [[nodiscard]] std::uint64_t clipped_samples() const noexcept override {
    return recorder_.clipped_samples();
  }

 private:
  /// What the JSON says of a voice beyond what its recorder knows.
  struct Story {
    std::string tag;
    std::vector<std::pair<double, Vec3>> way;  // time in the stream, s, and direction: ten a second
    bool written = false;                      // as it stands
    std::size_t due = 0;  // steps of the way from which it is written anew, if it goes on
  };

  void follow(const HopResult& hop);
  IoStatus tell_stories();
  IoStatus tell(const Voice& voice, Story& story) const;

  std::filesystem::path folder_;
  AudioSink::Stream stream_;
  int sample_rate_;
  double hop_seconds_;
  std::chrono::system_clock::time_point start_;
  VoiceRecorder recorder_;
  std::vector<Story> stories_;  // of each voice of the recorder
};

/// `20250131T120000.125Z`: sorts, and may stand in a file name on every system.
[[nodiscard]] std::string compact_time(std::chrono::system_clock::time_point instant);

}  // namespace odas
