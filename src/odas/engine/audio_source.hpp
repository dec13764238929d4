// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "odas/base/grid.hpp"
#include "odas/engine/io_status.hpp"

namespace odas {

/// What one read gave.
struct ReadResult {
  std::size_t frames = 0;  // delivered: columns 0 .. frames-1 of the block
  bool end = false;        // there is no more after these
  IoStatus status;         // why it ended, if not by itself; then `end` is true
  /// Frames that were lost before these: an overrun, a device that was unplugged, a peer that was away. The
  /// time stamps go on as if they had been there.
  std::uint64_t lost = 0;
  /// What a user should know at once: "hw:CARD=Array was unplugged; waiting for it". Rare.
  std::string notice{};
};

/// The longest that one read of a live source waits, so that the program stays able to stop.
inline constexpr std::chrono::milliseconds kReadPatience{100};

/// Where the microphones come from: a file, a sound card, a socket. Full scale is 1.
class AudioSource {
 public:
  virtual ~AudioSource() = default;

  [[nodiscard]] virtual std::size_t channels() const noexcept = 0;
  [[nodiscard]] virtual int sample_rate() const noexcept = 0;

  /// Paced by a clock that does not wait for us: what is not taken in time is lost.
  [[nodiscard]] virtual bool live() const noexcept = 0;

  /// Length of the whole, where it is known.
  [[nodiscard]] virtual std::optional<std::uint64_t> total_frames() const noexcept { return std::nullopt; }

  /// Fills `block` [channel][frame]. A recording fills all of it until its end; a live source gives what it
  /// has within kReadPatience, which may be nothing.
  [[nodiscard]] virtual ReadResult read(GridView<float> block) = 0;

  /// The run is over, for whatever reason; nothing is read any more. What could not be kept is said.
  virtual IoStatus finish() { return {}; }

  /// What was odd about the recording, known at its end: "ends early, ...". Empty: nothing.
  [[nodiscard]] virtual std::string warning() const { return {}; }
};

}  // namespace odas
