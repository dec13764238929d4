// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/array/types.hpp"

namespace odas {

/// Tells of each track whether it speaks: writes `Track::category`, `undefined` into empty slots.
///
/// Shapes: separated [slot][hop], full scale 1, before any gain; tracks [slot].
/// What a slot remembers is forgotten when its id changes. A sample that is not finite counts as silence.
class Classifier {
 public:
  virtual ~Classifier() = default;

  virtual void classify(GridView<const float> separated, std::span<Track> tracks) noexcept = 0;

  /// The state after construction, exactly.
  virtual void reset() noexcept = 0;
};

}  // namespace odas
