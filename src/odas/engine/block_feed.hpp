// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/run.hpp"

namespace odas {

/// What a run takes from its source, block by block, by the rules of its options: where it begins, where it
/// ends, and why. Shared by the run with threads and the one without, so that both see the same.
class BlockFeed {
 public:
  /// Fills in `frames`, `end`, `fault`, `warnings` and `metrics.lost_frames` of the summary.
  BlockFeed(AudioSource& source, const RunOptions& options, RunSummary& summary);

  struct Block {
    std::size_t frames = 0;  // a live source may give none for now
    std::uint64_t lost = 0;  // frames lost before these
  };
  /// Fills `block` [channel][frame] and says with how much, or gives nothing when the run is over.
  /// `cancelled`: something else has failed.
  [[nodiscard]] std::optional<Block> next(GridView<float> block, bool cancelled = false);

  /// The run is over: the source may finish what it keeps.
  void finish();

  /// Tells a warning at once and keeps it for the summary.
  void warn(std::string warning);

 private:
  AudioSource& source_;
  const RunOptions& options_;
  RunSummary& summary_;
  bool first_ = true;
  bool over_ = false;
};

}  // namespace odas
