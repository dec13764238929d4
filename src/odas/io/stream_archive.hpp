// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "odas/io/stream_record.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas {

/// The folder of one run of odasserver: `tracks.jsonl`, `potentials.jsonl`, `categories.jsonl`, WAV files,
/// and `connections.jsonl`, which says when each came. A file is there once something belongs into it.
class StreamArchive {
 public:
  using Instant = std::chrono::system_clock::time_point;

  /// `hop_seconds`: of the sender's time stamps. Makes the folder. Throws IoError: it cannot be made, or
  /// something is in it, which would be overwritten.
  StreamArchive(std::filesystem::path folder, double hop_seconds);
  /// A folder that nothing came into goes again.
  ~StreamArchive();
  StreamArchive(const StreamArchive&) = delete;
  StreamArchive& operator=(const StreamArchive&) = delete;

  /// Writes what was received at `now`. A line of `jsonl` stays as it is; of others `utc` is `now`.
  IoStatus add(const StreamRecord& record, std::string_view text, Instant now);

  /// A line of `connections.jsonl`: "begin", "end", or "file", whose first sample came then.
  struct Event {
    std::string stream, what, from, file;
    std::uint64_t bytes = 0;
  };
  IoStatus note(const Event& event, Instant now);

  /// `separated.wav`, and for the connections after the first `separated_2.wav`, ... Throws IoError.
  [[nodiscard]] std::unique_ptr<WavWriter> open_wav(const std::string& stream,
                                                    const WavWriter::Format& format);

  /// What was written so far is valid where it lies.
  IoStatus flush();
  /// Finishes all files.
  IoStatus close();

  [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }

 private:
  IoStatus write_line(const std::string& name, std::string_view line);

  std::filesystem::path folder_;
  double hop_seconds_;
  bool made_ = false;
  std::map<std::string, std::unique_ptr<FileWriter>> files_;
  std::map<std::string, int> recordings_;  // of each stream
};

}  // namespace odas
