// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "odas/io/allowed_senders.hpp"
#include "odas/io/stream_archive.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas {

/// The streams that ODAS sends, each to a port of its own.
enum class Stream { tracked, potential, category, separated, postfiltered };
inline constexpr std::size_t kStreams = 5;
inline constexpr std::array<const char*, kStreams> kStreamNames{"tracked", "potential", "category",
                                                                "separated", "postfiltered"};

struct StreamServerConfig {
  std::string listen;                              // "": 127.0.0.1
  std::vector<std::string> allow;                  // who may send from elsewhere
  std::array<std::optional<int>, kStreams> ports;  // none: not listened for; 0: the system chooses
  WavWriter::Format separated{44100, 4, 16};       // ODAS's, whose streams do not say it
  WavWriter::Format postfiltered{44100, 4, 16};
  std::function<void(const std::string&)> say{};        // who comes, goes and speaks nonsense
  std::function<void(std::span<const Track>)> heard{};  // the tracks of each hop, [slot]
};

/// Receives the streams of ODAS or odas, and archives them: what the program odasserver does.
///
/// One thread, that of who calls `step`. A port has one sender at a time: another one is turned away while
/// the first speaks, and takes his place once he has been silent for kSilence. Each connection begins anew,
/// with a whole record or sample; what is no record is said, and passed over. The ports of text take any of
/// the three streams of text, for their rows say which it is.
class StreamServer {
 public:
  static constexpr std::chrono::seconds kSilence{3};

  /// Throws IoError where it cannot listen, or knows no such sender.
  StreamServer(const StreamServerConfig& config, StreamArchive& archive);
  ~StreamServer();
  StreamServer(const StreamServer&) = delete;
  StreamServer& operator=(const StreamServer&) = delete;

  /// Waits at most so long for something to come, and takes it. A failure is one of the archive's.
  IoStatus step(std::chrono::milliseconds patience);
  /// What was written so far is valid where it lies.
  IoStatus flush();
  /// Takes what has come already, and finishes all recordings.
  IoStatus close();

  /// [slot], as they were told last, with the class of each; none once the sender has gone or is silent.
  [[nodiscard]] std::span<const Track> tracks() const noexcept { return tracks_; }
  /// A line for each port: who sends, and how much has come.
  [[nodiscard]] std::vector<std::string> state() const;
  /// "127.0.0.1:9000"; "": not listened for.
  [[nodiscard]] std::string where(Stream stream) const;

 private:
  class Port;
  IoStatus receive(const StreamRecord& record, std::string_view text);
  /// Whether something is there to be taken, at once or in a while.
  [[nodiscard]] bool is_asked(std::chrono::milliseconds patience) const;
  void say(const std::string& what) const;

  StreamServerConfig config_;
  StreamArchive& archive_;
  AllowedSenders allowed_;
  std::vector<std::unique_ptr<Port>> ports_;
  std::vector<Track> tracks_;
  std::vector<Category> categories_;  // [slot]
  std::chrono::steady_clock::time_point told_{};
};

}  // namespace odas
