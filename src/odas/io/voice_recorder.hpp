// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/engine/io_status.hpp"
#include "odas/io/report_history.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas {

/// A file with the voice of one source.
struct Voice {
  std::uint64_t id = 0;
  std::string file;    // within the folder
  double start_s = 0;  // where its first sample lies in the recording
  double seconds = 0;  // its length
};

/// `source_3.wav`
[[nodiscard]] std::string voice_file_name(std::uint64_t id);

/// Writes one WAV file per followed source: the audio of its slot from the hop in which its id appears to the
/// hop in which it is gone. A source that comes back with its id (`sst.memory`) gets one more file.
class VoiceRecorder {
 public:
  struct Format {
    int sample_rate = 16000;  // of the voices
    double hop_seconds = 0;   // of a time step
    double delay_s = 0;       // by which the voices come later than the microphones
    float gain = 1;
    /// The name of a voice by its id and start, s. Empty: source_3.wav, and source_3_2.wav when it comes
    /// back.
    std::function<std::string(std::uint64_t id, double start_s)> file_name{};
  };

  /// Makes the folder; removes the voices of an earlier run, unless they have names of their own. Throws
  /// IoError.
  VoiceRecorder(std::filesystem::path folder, Format format);

  /// `audio` is [slot][samples of this hop].
  IoStatus add(HopIndex time, std::span<const Track> tracks, GridView<const float> audio);

  /// What was written so far is valid where it lies.
  IoStatus flush();
  /// Finishes all files, also after a failure.
  IoStatus close();

  /// Takes a finished voice out of `voices`, those behind it move up: a run that never ends must not grow
  /// with what it has heard. Only where voices have names of their own.
  void forget(std::size_t voice);

  /// In order of appearance.
  [[nodiscard]] const std::vector<Voice>& voices() const noexcept { return voices_; }
  /// The one that a slot is adding to, an index of `voices`; none: the slot is empty.
  [[nodiscard]] std::optional<std::size_t> voice_of(std::size_t slot) const noexcept;
  [[nodiscard]] bool is_open(std::size_t voice) const noexcept;
  /// Samples that were louder than full scale, and were held at it.
  [[nodiscard]] std::uint64_t clipped_samples() const noexcept { return clipped_; }

 private:
  [[nodiscard]] std::string name_of(std::uint64_t id, double start_s) const;
  IoStatus begin(std::size_t slot, std::uint64_t id, double start_s);

  struct Open {
    std::size_t voice = 0;           // index in voices_
    std::unique_ptr<WavWriter> wav;  // none: the slot is empty
  };

  std::filesystem::path folder_;
  Format format_;
  std::vector<Voice> voices_;
  std::vector<Open> open_;  // [slot]
  std::vector<char> bytes_;
  std::uint64_t clipped_ = 0;
};

/// `index.json` beside the voices: id, tag, file, time and mean direction of each. Throws IoError.
void write_voice_index(const std::filesystem::path& file, std::span<const Voice> voices,
                       std::span<const SourceHistory> sources);

}  // namespace odas
