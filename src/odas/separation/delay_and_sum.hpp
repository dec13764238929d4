// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "odas/separation/beamformer.hpp"
#include "odas/separation/steering.hpp"

namespace odas {

/// Delay-and-sum beamformer (`dds`).
///
/// Method: W_m = conj(A_m) / (eps + sum |A_m|^2), y = sum W_m x_m over the microphones that hear the
///   direction. Gain 1 in the look direction, zero phase at the origin of the array.
/// Symbols: A: steering vector (Steering).
/// Source: Grondin and Michaud, "Lightweight and optimized sound source localization and tracking methods",
///   2019; ODAS 9.2. Departs: a direction that nobody hears gives silence (ODAS crashes).
/// Shapes: see Beamformer. Delay: none. Cost per hop: slots x mics x bins complex products; steering only
///   where the direction moved.
/// Fails: gives little separation below c / aperture, and none between close directions.
class DelayAndSum final : public Beamformer {
 public:
  DelayAndSum(const GeneralConfig& general, std::size_t slots);

  void separate(GridView<const cfloat> spectra, std::span<const Track> tracks,
                GridView<cfloat> beams) noexcept override;
  [[nodiscard]] GridView<const cfloat> weights(std::size_t slot) const noexcept override;
  void reset() noexcept override;

 private:
  struct Slot {
    bool steered = false;  // the weights are those of `direction`; else they are zero
    Vec3 direction;
    Grid<float> weights;             // [mic][2 bins padded]: re, im, ...
    std::vector<std::size_t> heard;  // the mics whose weights are not zero
  };

  void steer(Slot& slot, Vec3 direction) noexcept;
  void form(const Slot& slot, std::span<cfloat> beam) const noexcept;

  float epsilon_;
  Steering steering_;
  std::vector<float> gains_;  // [mic]
  std::vector<Slot> slots_;
  // The spectra, each part twice in a row, so that products with weights need no shuffles.
  Grid<float> real_;  // [mic][2 bins padded]: re, re, ...
  Grid<float> imag_;  // [mic][2 bins padded]: im, im, ...
};

}  // namespace odas
