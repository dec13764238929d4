// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "odas/array/types.hpp"

namespace odas {

/// What a followed source is.
enum class Category : std::uint8_t {
  undefined,  // an empty slot
  nonspeech,
  speech,
};

/// Tells for each track whether it speaks.
///
/// Shapes: separated [slot][hop], tracks [slot], categories [slot].
/// What a slot remembers is forgotten when its id changes. A sample that is not finite counts as silence.
class Classifier {
 public:
  virtual ~Classifier() = default;

  virtual void classify(GridView<const float> separated, std::span<const Track> tracks,
                        std::span<Category> categories) noexcept = 0;

  /// The state after construction, exactly.
  virtual void reset() noexcept = 0;
};

}  // namespace odas
