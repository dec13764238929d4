// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "odas/array/types.hpp"

namespace odas {

/// Follows the noise power of several channels, each by itself.
class NoiseEstimator {
 public:
  virtual ~NoiseEstimator() = default;

  /// The next hop of a channel; power[bin] = |X|^2.
  virtual void update(std::size_t channel, std::span<const float> power) noexcept = 0;
  /// The estimate, [channel][bin]; zero before the first sound.
  [[nodiscard]] virtual GridView<const float> psd() const noexcept = 0;

  /// Begins a channel anew, from what is known of its noise; from nothing where that is silence or not
  /// finite.
  virtual void reset(std::size_t channel, std::span<const float> known) noexcept = 0;
  virtual void reset(std::size_t channel) noexcept = 0;
};

}  // namespace odas
