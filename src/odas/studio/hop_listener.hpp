// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "odas/engine/config.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// What a run is, for those who show or keep it.
struct StreamInfo {
  enum class Kind : std::uint8_t { live, recording, odas };

  std::uint64_t run = 0;    // another one each time; hops begin anew
  std::string name;         // of the array or the configuration
  std::string source;       // "hw:CARD=Array", "meeting.wav"
  std::string config_text;  // as it runs
  std::string config_hash;
  Kind kind = Kind::live;
  int sample_rate = 16000;
  std::size_t hop_size = 128;
  std::size_t slots = 0;
  std::size_t potentials = 0;
  double lookback_s = 0;
  double voice_delay_s = 0;                     // voices come so much later than the microphones
  float separated_gain = 1;                     // sss.gain_sep: of all that plays or keeps these voices
  float postfiltered_gain = 1;                  // sss.gain_pf
  std::vector<MicConfig> mics;                  // none: unknown
  std::vector<int> channels;                    // [mic], from 1
  std::vector<Vec3> power_grid;                 // directions of HopResult::power
  std::chrono::system_clock::time_point start;  // of the first hop

  [[nodiscard]] std::chrono::system_clock::time_point at(HopIndex time) const {
    const double s = static_cast<double>(time - 1) * static_cast<double>(hop_size) / sample_rate;
    return start +
           std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::duration<double>(s));
  }
};

/// Somebody who wants every hop of every run: the page's server, who records, who tells others of events.
/// All three are called in one thread, the writers' (never the engine's). They may take a lock for a moment
/// and write to a disk, and must not wait for a peer.
class HopListener {
 public:
  virtual ~HopListener() = default;
  /// A run begins, with another `run`.
  virtual void begin(const StreamInfo& info) = 0;
  /// The same run goes on, hop after hop and with the same ids, by another configuration of the same shapes:
  /// `config_hash`, gains and the places of microphones may be others.
  virtual void change(const StreamInfo& info) { static_cast<void>(info); }
  /// Every hop in order; `time` jumps where hops were lost. The views hold during the call; any may be empty.
  virtual void hop(const HopResult& hop) = 0;
  virtual void end() = 0;
};

}  // namespace odas
