// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "odas/studio/hop_listener.hpp"
#include "odas/studio/meters.hpp"
#include "odas/studio/wire.hpp"

namespace odas {

/// A hop as clients get it: encoded once, however many there are.
struct HopFrame {
  HopIndex time = 0;
  std::string full, bare;          // JSON with and without potentials
  std::vector<std::uint64_t> ids;  // [slot]; 0: empty
  std::array<std::vector<std::int16_t>, kAudioStreams>
      pcm;  // [row][sample], rows one after another; may be empty
};

/// The last hops of a run, for any number of readers, each at a place of his own. Who falls behind further
/// than it reaches has lost what is gone, and nobody waits for him: that is all the queue a client has.
///
/// Threads: the writers' calls `begin`, `hop` and `end`, the server's all others; a lock for microseconds.
class HopRing final : public HopListener {
 public:
  /// Bytes of JSON and sound that it holds at most; the oldest go first. Seconds of sound, about a minute of
  /// tracks.
  static constexpr std::size_t kRoom = std::size_t{8} << 20;

  void begin(const StreamInfo& info) override;
  void hop(const HopResult& hop) override;
  void end() override;

  /// What clients have asked for, so that nothing is encoded for nobody.
  struct Demand {
    bool hops = false, bare = false, meters = false, power = false;
    std::array<bool, kAudioStreams> audio{};
    friend bool operator==(const Demand&, const Demand&) = default;
  };
  void demand(const Demand& demand);

  using Frame = std::shared_ptr<const HopFrame>;
  struct Power {
    HopIndex time = 0;
    std::vector<float> energy;  // [direction]
  };
  /// A run, as of now; none before the first one.
  [[nodiscard]] std::optional<StreamInfo> run() const;
  [[nodiscard]] std::uint64_t run_id() const;
  /// One past the number of the newest frame. Numbers go on from run to run.
  [[nodiscard]] std::uint64_t end_number() const;
  struct Reading {
    std::uint64_t run = 0;
    std::uint64_t first = 0;    // number of the first frame
    std::uint64_t lost = 0;     // frames of this run between the asked one and the first
    std::vector<Frame> frames;  // all of this run
  };
  /// At most so many frames from number `next` on.
  [[nodiscard]] Reading read(std::uint64_t next, std::size_t most) const;
  /// The newest, and its number, from 1; 0: none yet.
  [[nodiscard]] std::uint64_t meters(MeterReading& to) const;
  [[nodiscard]] HopIndex power(Power& to) const;
  /// What the beamformer said last of each voice: those of slots with a voice, in their order.
  struct Beams {
    HopIndex time = 0;
    struct Beam {
      std::size_t slot = 0;
      BeamReport report;
    };
    std::vector<Beam> beams;
  };
  [[nodiscard]] Beams beams() const;
  /// When the newest hop came, and what it was.
  struct Pulse {
    HopIndex time = 0;
    std::chrono::system_clock::time_point came;
  };
  [[nodiscard]] Pulse pulse() const;

 private:
  void drop_old();
  void note_beams(const HopResult& hop);

  mutable std::mutex mutex_;
  std::optional<StreamInfo> info_;
  Demand demand_;
  std::deque<Frame> frames_;
  std::uint64_t end_ = 0;        // number
  std::uint64_t run_begin_ = 0;  // number of the first frame of the run
  std::size_t bytes_ = 0;
  MicMeters meters_;
  MeterReading reading_;
  std::uint64_t readings_ = 0;
  Power power_;
  Beams beams_;
  Pulse pulse_;
};

}  // namespace odas
