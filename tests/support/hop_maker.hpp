// SPDX-License-Identifier: MIT
// Hops of hand for who listens to them: in each slot the voice of its track, which tells whose it is.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "odas/studio/hop_listener.hpp"

namespace odas::test {

/// The sample `i` of the voice of a track: a tone, each id another one, full scale 0.5.
inline float tone_of(std::uint64_t id, std::uint64_t i) {
  const double step = 2 * std::numbers::pi * 250.0 * static_cast<double>(id) / 16000;
  return static_cast<float>(0.5 * std::sin(step * static_cast<double>(i % 16000)));
}
/// As it stands in a file of 16 bits.
inline std::int16_t tone_sample(std::uint64_t id, std::uint64_t i) {
  return static_cast<std::int16_t>(std::lround(tone_of(id, i) * 32768));
}

/// Makes one hop after the other. `ids` [slot]; sample i of a voice is tone_of(id, i), i since the start of
/// the run; microphone m is tone_of(m + 1, i).
class HopMaker {
 public:
  explicit HopMaker(std::size_t slots = 2, std::size_t mics = 3) : mics_(mics) { hop_.tracks.resize(slots); }

  [[nodiscard]] StreamInfo info() const {
    StreamInfo info;
    info.run = 1;
    info.name = "test array";
    info.config_hash = "abcd";
    info.slots = hop_.tracks.size();
    info.potentials = 1;
    info.voice_delay_s = 0.016;
    info.mics.resize(mics_);
    info.start = std::chrono::system_clock::time_point(std::chrono::seconds(1769860800));
    return info;
  }

  /// The next hop goes to the listener.
  void play(HopListener& to, const std::vector<std::uint64_t>& ids) { to.hop(next(ids)); }
  HopResult next(const std::vector<std::uint64_t>& ids) {
    ++time;
    constexpr std::size_t kHop = 128;
    const std::uint64_t first = (time - 1) * kHop;
    voices_ = Grid<float>(ids.size(), kHop);
    sound_ = Grid<float>(mics_, kHop);
    hop_.tracks.resize(ids.size());
    for (std::size_t s = 0; s < ids.size(); ++s) {
      Track& track = hop_.tracks[s];
      track = {};
      if (ids[s] == 0) continue;
      track.id = ids[s];
      track.tag = "dynamic";
      track.direction = {0, 1, 0};
      track.activity = 1;
      track.category = category;
      for (std::size_t i = 0; i < kHop; ++i) voices_[s][i] = tone_of(ids[s], first + i);
    }
    for (std::size_t m = 0; m < mics_; ++m) {
      for (std::size_t i = 0; i < kHop; ++i) sound_[m][i] = tone_of(m + 1, first + i);
    }
    hop_.potentials = {{{1, 0, 0}, 0.5F}};
    HopResult result{time, hop_.potentials, hop_.tracks, voices_.view(), {}, {}, {}};
    if (with_mics) result.mics = sound_.view();
    if (!with_voices) result.separated = {};
    return result;
  }

  HopIndex time = 0;  // of the last hop
  bool with_mics = true, with_voices = true;
  Category category = Category::undefined;

 private:
  struct Hop {
    std::vector<Potential> potentials;
    std::vector<Track> tracks;
  } hop_;
  std::size_t mics_;
  Grid<float> voices_, sound_;
};

}  // namespace odas::test
