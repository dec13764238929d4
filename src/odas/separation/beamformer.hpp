// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "odas/array/types.hpp"
#include "odas/separation/beam_report.hpp"

namespace odas {

class NoiseField;

/// Gives each track the sound from its direction: y = sum over mics of W_m x_m, per slot and bin.
///
/// Shapes: spectra [mic][bin], tracks [slot], beams [slot][bin].
/// A slot with id 0, or whose direction no microphone hears, gives zeros. What a slot remembers is forgotten
/// when its id changes. A non-finite input gives a non-finite output in that hop at most.
class Beamformer {
 public:
  virtual ~Beamformer() = default;

  virtual void separate(GridView<const cfloat> spectra, std::span<const Track> tracks,
                        GridView<cfloat> beams) noexcept = 0;

  /// [mic][bin]: the demixing weights W that the last hop applied; zero where a microphone does not hear
  /// the direction, and in empty slots.
  [[nodiscard]] virtual GridView<const cfloat> weights(std::size_t slot) const noexcept = 0;

  /// The machine's own noise, for those that can null it; it outlives the beamformer. Called once, if at all,
  /// before the first hop.
  virtual void use_noise(const NoiseField* /*noise*/) noexcept {}

  /// [bin]: the share of the slot's talker in the sound of the last hop, 0..1; empty where the method has
  /// none.
  [[nodiscard]] virtual std::span<const float> mask(std::size_t /*slot*/) const noexcept { return {}; }

  /// How well it goes, for a slot that lives. What is not said otherwise: nothing but the gain of the
  /// weights.
  [[nodiscard]] virtual BeamReport report(std::size_t slot) const noexcept {
    constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
    return {kUnknown, white_noise_gain_db(weights(slot)), kUnknown};
  }

  /// The state after construction, exactly.
  virtual void reset() noexcept = 0;
};

}  // namespace odas
