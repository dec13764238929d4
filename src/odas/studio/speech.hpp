// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "odas/studio/speech_program.hpp"
#include "odas/studio/wire.hpp"

namespace odas {

/// Words of a track; times as of the run, s.
struct SpokenText {
  std::uint64_t track = 0;
  std::string text;
  bool is_final = false;
  double from_s = 0, to_s = 0;
};

/// Has what is said written down by a program of the user's, started once for each voice: PCM of 16 bits, one
/// channel, comes at its standard input, and it writes lines of JSON, {"text":"...","final":true}. Off
/// without a command. docs/protocol.md tells more.
///
/// A thread of its own serves the programs. One that does not read loses sound, one that says too much or
/// does not end is killed, and after kFailures that ended at once none is started any more in this run: each
/// is said once, and nobody else notices.
class Speech : public HopListener {
 public:
  static constexpr std::size_t kPrograms = 16;    // at a time
  static constexpr int kFailures = 3;             // programs in turn that ended without a word
  static constexpr double kShortest = 0.3;        // s: a voice that ends before is no word
  static constexpr double kBuffered = 10;         // s of sound that may wait for a program
  static constexpr std::size_t kFlood = 1 << 18;  // bytes within a second

  struct Options {
    std::string command;                             // "": off
    std::chrono::milliseconds patience{10'000};      // for a program whose voice has ended
    std::chrono::milliseconds farewell{1000};        // at the end of it all
    std::function<void(const SpokenText&)> heard{};  // in the thread of this
    std::function<void(const std::string& level, const std::string& text)> say{};
  };

  explicit Speech(Options options);
  ~Speech() override;
  Speech(const Speech&) = delete;
  Speech& operator=(const Speech&) = delete;

  void begin(const StreamInfo& info) override;
  void hop(const HopResult& hop) override;
  void end() override;

 private:
  using Clock = std::chrono::steady_clock;

  /// A voice and its program.
  struct Voice {
    std::uint64_t track = 0;
    int rate = 16000;
    double start_s = 0;   // of its sound
    std::string waiting;  // bytes for the program
    std::uint64_t samples = 0;
    bool over = false;     // no more sound comes
    bool is_deaf = false;  // its program has gone
    Clock::time_point ended{};
    // Of the thread alone:
    std::unique_ptr<SpeechProgram> program;
    std::string line;
    double said_until_s = 0;  // of its own time
    std::size_t said = 0;     // bytes in this second
    Clock::time_point second{};
    bool has_spoken = false, was_killed = false, has_exited = false, was_quiet = false;
  };

  void run();
  /// Those of voices that are long enough; all that run.
  std::vector<Voice*> start_programs();
  void serve(Voice& voice);
  void take_line(Voice& voice, const std::string& line);
  [[nodiscard]] bool is_done(Voice& voice);
  void say_once(const char* kind, const std::string& text);

  Options options_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::list<Voice> voices_;
  std::optional<StreamInfo> info_;
  bool ending_ = false;
  Clock::time_point until_{};
  int failures_ = 0;
  std::vector<std::string> said_;  // kinds, in this run
  std::vector<char> bytes_;
  std::thread thread_;
};

}  // namespace odas
