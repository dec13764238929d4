// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// An owned copy of the parts of a hop that a sink reads, to wait in its queue. Copying allocates nothing.
class HopRecord {
 public:
  /// Of the shapes that a pipeline of `config` gives; `power_directions`: the size of its power grid.
  HopRecord(const Wanted& wanted, const PipelineConfig& config, std::size_t power_directions = 0);

  void assign(const HopResult& hop) noexcept;
  [[nodiscard]] HopResult view() const noexcept;

  /// No hop: the run is over.
  bool end = false;

 private:
  HopIndex time_ = 0;
  std::vector<Potential> potentials_;
  std::vector<Track> tracks_;
  Grid<float> separated_;
  Grid<float> postfiltered_;
  Grid<float> mics_;
  std::vector<float> power_;
  std::vector<BeamReport> reports_;
};

}  // namespace odas
