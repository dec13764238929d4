// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "odas/studio/sample_ring.hpp"
#include "odas/studio/take.hpp"

namespace odas {

/// Records voices and microphones of a run: one voice, each voice from now on, or all microphones.
///
/// A recording begins with the look-back of its voice (`preroll`), never with another one's: what came before
/// a slot's id changed is forgotten. It ends with its voice. Where hops are lost it has silence, so that each
/// sample keeps its time. Voices have 16 bits and the gain of the configuration, microphones 24.
///
/// One thread at a time. What goes wrong with a file ends that recording and is told by `faults`.
class Recorder {
 public:
  enum class What { track, all, raw };
  struct Order {
    What what = What::track;
    AudioStream stream = AudioStream::separated;
    std::uint64_t track = 0;
    double preroll_s = 0;
  };
  /// What is being recorded.
  struct Job {
    Order order;
    std::vector<std::string> names;  // of its files so far
    double begun_s = 0;              // of the run
  };

  Recorder(std::filesystem::path folder, double longest_preroll_s)
      : folder_(std::move(folder)), preroll_s_(longest_preroll_s) {}

  void begin(const StreamInfo& info);
  void hop(const HopResult& hop);
  /// The run is over, and so are all recordings.
  void end();

  /// Throws IoError: nothing is running, there is no such voice or stream, or the disk says no.
  void start(std::uint64_t job, const Order& order);
  /// The names of its files; none: there is no such job.
  std::optional<std::vector<std::string>> stop(std::uint64_t job);
  [[nodiscard]] const std::map<std::uint64_t, Job>& jobs() const noexcept { return jobs_; }
  /// Since its job began, s.
  [[nodiscard]] double seconds_of(const Job& job) const noexcept { return now_s() - job.begun_s; }

  void flush();
  void add(std::uint64_t track, const Transcript& transcript);
  [[nodiscard]] bool is_open(const std::string& name) const;
  /// Names a recording that is being made; false: there is none such.
  bool set_label(const std::string& name, const std::string& label);
  /// What has gone wrong since the last call, and which recordings have ended by themselves.
  [[nodiscard]] std::vector<std::string> take_faults() { return std::exchange(faults_, {}); }

 private:
  /// The channel of a voice, or all microphones together.
  struct Lane {
    std::uint64_t id = 0;  // 0: nobody; of the microphones 1
    std::string tag;
    SampleRing ring;
  };
  struct Open {
    std::uint64_t job;
    AudioStream stream;
    std::size_t lane;
    Take take;
  };

  void hear(const HopResult& hop, AudioStream stream);
  void refuse_jobs_without_sound();
  void open(std::uint64_t job, AudioStream stream, std::size_t lane, double preroll_s);
  void close(AudioStream stream, std::size_t lane);
  void finish(Open& open);
  void drop_jobs_of(std::uint64_t track, AudioStream stream);
  template <class Act>
  void for_takes(AudioStream stream, std::size_t lane, Act act);
  [[nodiscard]] double now_s() const noexcept;

  std::filesystem::path folder_;
  double preroll_s_;
  std::optional<StreamInfo> info_;  // none: nothing runs
  HopIndex time_ = 0;               // of the last hop
  std::array<std::vector<Lane>, kAudioStreams> lanes_;
  std::array<HopIndex, kAudioStreams> heard_{};  // the last hop that had sound
  std::map<std::uint64_t, Job> jobs_;
  std::deque<Open> open_;
  std::deque<std::pair<std::uint64_t, std::string>> finished_;  // id and file, of this run, the last ones
  std::vector<std::string> faults_;
  std::vector<char> bytes_;
};

}  // namespace odas
