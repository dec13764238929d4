// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "odas/base/grid.hpp"

namespace odas {

/// Watches the microphones for what no array survives unnoticed: dead, duplicate and clipped channels.
///
/// Method: over each second of sound, a microphone is
/// - silent, if all its samples are the same while another one's are not;
/// - the same as another one, if all their samples are equal and not silent;
/// - clipped, if one sample in a thousand or more is within 1 % of full scale.
/// And all are silent, if none has moved for five seconds. Each is said once a run.
/// Cost: one comparison a sample, for clipping; the others stop at the first sample that clears the suspect.
/// Threads: `watch` and `finish` in one; `take_warnings` may be called from another.
class InputHealth {
 public:
  /// `map`: the channel of each microphone, from 1, for the messages; 0 (silence) is not watched.
  InputHealth(std::vector<int> map, int sample_rate);

  /// `block` is [mic][any number of samples]. Allocates nothing.
  void watch(GridView<const float> block) noexcept;

  /// The input has ended: judges the last second, if it is at least a quarter.
  void finish() noexcept;

  /// What was found since the last call: "microphone 3 (channel 4) is silent".
  [[nodiscard]] std::vector<std::string> take_warnings();

 private:
  enum Kind : std::uint8_t { silent = 1, clipped = 2 };
  struct Mic {
    bool watched = true;
    bool moved = false;          // in this second: a sample differs from the first
    float first = 0;             // sample of this second
    std::uint64_t at_limit = 0;  // samples of this second within 1 % of full scale
  };

  void judge() noexcept;
  void start_window() noexcept;
  [[nodiscard]] std::string mic_name(std::size_t mic) const;

  std::vector<int> map_;
  std::vector<Mic> mics_;
  std::vector<std::vector<bool>> same_;  // [j][i < j]: equal so far in this second
  std::uint64_t window_;                 // samples of a second
  std::uint64_t seen_ = 0;               // samples of this second so far
  std::uint64_t still_seconds_ = 0;      // in which no microphone has moved
  bool ever_moved_ = false;

  // What was found; written by one thread, read by another.
  struct Found {
    std::atomic<std::uint8_t> kinds{0};
    std::atomic<int> same_as{-1};  // a microphone, from 0
    std::uint8_t told_kinds = 0;
    bool told_same = false;
  };
  std::unique_ptr<Found[]> found_;  // [mic]
  std::atomic<bool> all_silent_{false};
  bool told_all_silent_ = false;
};

}  // namespace odas
