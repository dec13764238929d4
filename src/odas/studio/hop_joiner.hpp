// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odas/dsp/resampler.hpp"
#include "odas/io/stream_record.hpp"
#include "odas/studio/wire.hpp"

namespace odas {

/// Joins the streams of ODAS into hops again: tracks, potentials, and two of sound.
///
/// Method: nothing in ODAS's sound says of which hop it is. Where a connection of tracks begins with time
/// stamp 1 and the sound has been there from its beginning, too, sample i is of hop 1 + i / hop, to the
/// sample, and channel k is the voice of row k. In any other case (who joined late, a sound that is not as
/// long as its tracks, other numbers of channels and rows) whose sound it is cannot be told: hops then come
/// without sound, and the reason is said. Tracks and potentials are never held back by more than kPatience.
class HopJoiner {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kPatience{3};  // for sound that does not come
  static constexpr std::chrono::seconds kTogether{1};  // streams of one start connect within this
  static constexpr double kSlip = 0.1;                 // s by which sound and tracks may drift
  static constexpr std::size_t kMostWaiting = 2500;    // hops of a stream

  struct Config {
    int rate = 16000;  // of the processing, to which the time stamps belong
    std::size_t hop = 128;
    int sound_rate = 16000;
    std::size_t channels = 4;
    std::string name = "ODAS", source;
  };
  using Say = std::function<void(const std::string& level, const std::string& text)>;

  /// `to` outlives it. Throws ConfigError: rates too far apart.
  HopJoiner(const Config& config, HopListener& to, Say say);

  /// A connection has come. What follows from it begins anew.
  void begin(StreamKind kind, Clock::time_point now);
  void begin(AudioStream stream, Clock::time_point now);
  /// It has gone.
  void end(StreamKind kind);
  void end(AudioStream stream);

  void add(const StreamRecord& record, Clock::time_point now);
  /// [channel][frame] of full scale 1, at most kMostFrames.
  void add(AudioStream stream, GridView<const float> block);
  static constexpr std::size_t kMostFrames = 4096;

  /// Gives the hops that are whole, or have waited for long enough. To be called after all that has come.
  void give(Clock::time_point now);

  /// So much waits that its sender should wait, too.
  [[nodiscard]] bool is_full_of_tracks() const noexcept { return waiting_.size() >= kMostWaiting; }
  [[nodiscard]] bool is_full_of(AudioStream stream) const noexcept;

 private:
  struct Sound {
    bool connected = false;
    bool matched = false;
    Clock::time_point begun{};
    std::unique_ptr<Resampler> to_hops;
    HopIndex next = 1;  // the hop of the first that waits
    std::deque<Grid<float>> waiting;
    std::optional<double> usual;  // s by which the sound is ahead of the tracks, at most, in a second
    double ahead = 0;             // the most in this second
  };
  struct Waiting {
    StreamRecord record;
    Clock::time_point since;
  };

  [[nodiscard]] Sound& of(AudioStream stream) { return sounds_[static_cast<std::size_t>(stream)]; }
  void begin_run(const StreamRecord& first);
  void end_run();
  void match(AudioStream stream);
  void part(AudioStream stream, const std::string& why);
  [[nodiscard]] bool is_ready(const Waiting& head, Clock::time_point now);
  void give_one();
  void watch_for_slips(Clock::time_point now);

  Config config_;
  HopListener& to_;
  Say say_;
  std::array<Sound, 2> sounds_;  // separated, postfiltered
  std::deque<Waiting> waiting_;  // tracks
  std::deque<StreamRecord> potentials_;
  bool has_potentials_ = false;
  HopIndex last_potential_ = 0;

  bool has_run_ = false;  // this connection of tracks
  Clock::time_point tracks_begun_{};
  std::uint64_t run_ = 0;
  bool running_ = false, from_the_start_ = false;
  HopIndex last_ = 0;  // the last time stamp that has come
  std::size_t slots_ = 0;
  Clock::time_point second_{};
  HopIndex second_from_ = 0;
};

}  // namespace odas
