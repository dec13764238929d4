// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odas/io/wav_writer.hpp"
#include "odas/studio/wire.hpp"

namespace odas {

/// What a recording is of.
struct TakeHead {
  AudioStream stream = AudioStream::separated;
  std::uint64_t track = 0;  // 0 of raw
  std::string tag;
  double start_s = 0;  // of the sound of its first sample, since the start of the run
  std::chrono::system_clock::time_point start;
  WavWriter::Format format;
  std::string config_name, config_hash;
};

/// What is said in a recording; times as of the run.
struct Transcript {
  double from_s = 0, to_s = 0;
  std::string text;
};

/// One recording while it is made: a WAV, and beside it a JSON file that says what it is. Both are good
/// whenever the program ends, as of the last `flush`.
class Take {
 public:
  static constexpr const char* kMaker = "odas studio";  // `made_by`: the mark of our own files

  /// A new file in the folder, with the time of its first sample in its name. Throws IoError.
  Take(const std::filesystem::path& folder, TakeHead head);

  IoStatus write(std::span<const char> frames);
  /// Samples that are lost: the recording keeps its time.
  IoStatus write_silence(std::size_t frames);
  /// Where the source is; `time` of the run, s.
  void steer(double time, Vec3 direction);
  void add(Transcript transcript);
  IoStatus set_label(std::string label);

  IoStatus flush();
  IoStatus close();

  [[nodiscard]] const TakeHead& head() const noexcept { return head_; }
  [[nodiscard]] std::string name() const { return wav_path_.filename().string(); }
  [[nodiscard]] double seconds() const noexcept;

 private:
  IoStatus tell();

  TakeHead head_;
  std::filesystem::path wav_path_;
  std::unique_ptr<WavWriter> wav_;
  std::uint64_t frames_ = 0;
  std::string label_;
  std::vector<std::pair<double, Vec3>> way_;
  std::vector<std::pair<double, double>> gaps_;  // begin in the file and length, s
  std::vector<Transcript> transcripts_;
  std::size_t due_ = 0;  // steps of the way from which the JSON is written anew
};

/// Adds to the JSON of a recording that is over.
IoStatus add_transcript(const std::filesystem::path& json_file, const Transcript& transcript);

}  // namespace odas
