// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/array/types.hpp"
#include "odas/separation/beamformer.hpp"

namespace odas {

/// Takes out of each beam what is left of noise and of the other sources: filtered = G beam, 0 <= G <= 1.
///
/// Shapes: spectra [mic][bin], noise_psd [mic][bin] (power of |X|^2), tracks [slot], beams and filtered
/// [slot][bin]. `beamformer` made these `beams` in this very hop.
/// A slot with id 0 gives zeros. What a slot remembers is forgotten when its id changes.
class PostFilter {
 public:
  virtual ~PostFilter() = default;

  virtual void apply(GridView<const cfloat> spectra, GridView<const float> noise_psd,
                     std::span<const Track> tracks, const Beamformer& beamformer,
                     GridView<const cfloat> beams, GridView<cfloat> filtered) noexcept = 0;

  /// Whether `noise_psd` is read. If not, it may be empty.
  [[nodiscard]] virtual bool needs_noise() const noexcept = 0;

  /// The state after construction, exactly.
  virtual void reset() noexcept = 0;
};

}  // namespace odas
