// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "odas/engine/io_status.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// Where results go: a file, the terminal, a listener. Called from one thread only, hop after hop.
///
/// A sink sees every hop in order; where hops were dropped (only a live source can bring that about), `time`
/// jumps, and a sink of audio fills the gap with silence so that its channels never slip.
class Sink {
 public:
  virtual ~Sink() = default;

  /// For messages: "sst.tracked (tracks.json)".
  [[nodiscard]] virtual std::string name() const = 0;

  /// The parts of a hop that it reads. The others may be empty.
  [[nodiscard]] virtual Wanted wanted() const noexcept = 0;

  /// Takes one hop. The views hold only during the call. A failure is said once and ends the run; the sink is
  /// not written to again, but it is closed.
  virtual IoStatus write(const HopResult& hop) = 0;

  /// Called at least once a second: what was written must now be where a reader sees it.
  virtual IoStatus flush() { return {}; }

  /// Finishes what is written. Called once, also after a failure: what is there must be whole.
  virtual IoStatus close() { return {}; }

  /// Hops (of audio: blocks) that nobody got: a peer was absent or did not read.
  [[nodiscard]] virtual std::uint64_t lost_records() const noexcept { return 0; }

  /// Samples that were louder than full scale, and were held at it.
  [[nodiscard]] virtual std::uint64_t clipped_samples() const noexcept { return 0; }
};

}  // namespace odas
