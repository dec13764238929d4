// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "odas/separation/beamformer.hpp"
#include "odas/separation/config.hpp"
#include "odas/separation/lanes.hpp"
#include "odas/separation/steering.hpp"

namespace odas {

/// Geometric source separation (`dgss`): each source passes, the others are nulled.
///
/// Method: stochastic gradient, in each bin and hop one step on decorrelation and one on geometry:
///   y = W x,  dJ1 = 4 E y x^H with E = y y^H - diag(y y^H),  dJ2 = 2 (W A - I) A^H,
///   W <- (1 - lambda mu) W - mu (alpha dJ1 + dJ2),  alpha = 1 / (|x|^4 + eps),  then y = W x.
///   E y is taken in closed form: (E y)_a = y_a (|y|^2 - |y_a|^2).
/// Symbols: W: demixing, row of a slot starts as delay-and-sum; A: steering vectors of the live slots;
///   mu, lambda: `sss.dgss`.
/// Source: Parra and Alvino, "Geometric source separation", 2002; Valin, Rouat and Michaud, "Enhanced robot
///   audition based on microphone array source separation with post-filter", 2004; ODAS 9.3. Departs from
///   ODAS: W is complex (there its imaginary part is lost, fault B2), and the weight of a microphone that
///   does not hear the source is zero in the gradient too; one that begins to hear it starts as
///   delay-and-sum.
/// Shapes: see Beamformer. Delay: none. Cost per hop: bins x slots x mics x (2 slots + 3) complex products.
/// Errors: a row that is not finite any more (a non-finite input, a step mu too large) starts afresh.
/// Fails: sources closer than about the beam's width share their nulls; reverberation leaks.
class GeometricSeparation final : public Beamformer {
 public:
  GeometricSeparation(const GssConfig& config, const GeneralConfig& general, std::size_t slots);

  void separate(GridView<const cfloat> spectra, std::span<const Track> tracks,
                GridView<cfloat> beams) noexcept override;
  [[nodiscard]] GridView<const cfloat> weights(std::size_t slot) const noexcept override;
  void reset() noexcept override;

 private:
  struct Slot {
    std::uint64_t id = 0;  // 0: its weights are zero
    bool steered = false;  // `steering` is that of `direction`
    Vec3 direction;
    std::vector<float> gains;  // [mic]: of `direction`; 0: does not hear it
    Grid<Lanes> steering;      // A [lane][mic]
    Grid<Lanes> demixing;      // W [lane][mic]
    Grid<cfloat> weights;      // W [mic][bin]
  };

  void follow(Slot& slot, const Track& track) noexcept;
  void steer(Slot& slot, Vec3 direction) noexcept;
  void forget(Slot& slot) noexcept;
  void adapt(std::size_t lane) noexcept;

  float mu_, lambda_, epsilon_;
  Steering steering_;
  std::vector<Slot> slots_;
  std::vector<Slot*> live_;      // of this hop
  Grid<Lanes> input_;            // x [lane][mic]
  std::vector<Lanes> outputs_;   // [live slot]: y of one lane
  std::vector<Lanes> response_;  // [live slot]: a row of W A - I, of one lane
  std::vector<Lanes> beam_;      // [lane]
  std::vector<float> gains_;     // [mic]
  std::vector<cfloat> row_;      // [bin]
};

}  // namespace odas
