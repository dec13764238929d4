// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "odas/separation/beamformer.hpp"
#include "odas/separation/bin_blocks.hpp"
#include "odas/separation/config.hpp"
#include "odas/separation/steering.hpp"
#include "odas/separation/stillness.hpp"
#include "odas/separation/talker_masks.hpp"

namespace odas {

/// Minimum variance distortionless response (`dmvdr`) and generalized eigenvalue (`dgev`) beamformers that
/// learn from masks, with no training and no knowledge but the directions of the tracks.
///
/// Method, per slot and bin, in each hop first learning and then forming the beam:
///   masks g of x (TalkerMasks), with the powers of the beams of the last weights;
///   c <- c + a g (x conj(x_ref) - c),  R <- R + a (1 - g) (x x^H - R) + loading,
///   n = R^-1 c,  h = c / c_ref: the measured transfer function relative to the reference microphone;
///   dmvdr: w = n / (h^H n + mu),  mu = tradeoff (1 - share) / share: the Wiener share of the noise
///   reduction; dgev: w = b n, b = |c| / (sqrt(M) c^H n): blind analytic normalization; y = ((1 - beta) w +
///   beta e_ref)^H x,  beta = rho / (rho + harm): one voice in quiet passes as it came in. Loading: a share
///   of the power of all else, and one of the talker's own, whose sound is never all explained; more of it
///   where the white noise gain falls under `whiteNoiseGain`. c begins with the direction and turns with it;
///   R begins as diffuse sound of the present level. Where the machine's own noise is known (use_noise), R
///   begins as this noise, and takes a column of its factor in each hop, as if the noise went on behind all
///   that is heard: R <- R + M a (1 - g) f_j f_j^H.
///   a: forgets within `memory` where all stand still, sooner from when somebody walks (Stillness).
/// Symbols: ref: the microphone that hears the direction best; share: mean of g; rho: power of the talker
///   over that of the other talkers and of the noise floor; M: microphones; f_j: column j of NoiseField, j
///   the hop mod M.
/// Source: Souden, Benesty and Affes, "On optimal frequency-domain multichannel linear filtering for noise
///   reduction", 2010; Warsitz and Haeb-Umbach, "Blind acoustic beamforming based on generalized eigenvalue
///   decomposition", 2007 (the target being of rank one, its eigenvector is R^-1 c). Departs: only one
///   column of the talker's covariance is kept; R is kept as its Cholesky factor, updated by rank one.
/// Shapes: see Beamformer. Delay: none. Cost per hop: bins x (1/2 + 2.5 slots) mics^2 complex products;
///   slots x bins x mics^2 more with a known noise.
/// Errors: a bin that is not finite gives silence and is not learned from.
/// Fails: see TalkerMasks; all talkers' nulls take microphones: with as many as those, little is gained.
class AdaptiveBeamformer : public Beamformer {
 public:
  enum class Criterion : std::uint8_t { mvdr, gev };

  AdaptiveBeamformer(Criterion criterion, const AdaptiveConfig& config, const GeneralConfig& general,
                     std::size_t slots);

  void separate(GridView<const cfloat> spectra, std::span<const Track> tracks,
                GridView<cfloat> beams) noexcept override;
  void use_noise(const NoiseField* noise) noexcept override { known_ = noise; }
  [[nodiscard]] GridView<const cfloat> weights(std::size_t slot) const noexcept override;
  [[nodiscard]] std::span<const float> mask(std::size_t slot) const noexcept override {
    return {masks_.mask(slot).data(), bins_};
  }
  [[nodiscard]] BeamReport report(std::size_t slot) const noexcept override;
  void reset() noexcept override;

 private:
  struct Slot {
    std::uint64_t id = 0;  // 0: empty
    bool heard = false;    // at least one microphone hears the direction
    Vec3 direction;        // of `steering`
    std::size_t reference = 0;
    BinBlocks steering;           // d [mic]
    BinBlocks column;             // c [mic]
    BinBlocks factor;             // L of R
    BinBlocks solved;             // n [mic]
    BinReals response;            // h^H n
    BinReals talker;              // c_ref: mean power of the talker where he is heard
    BinReals level;               // mean power of all else
    BinReals share;               // mean of g
    BinReals loading;             // times `loading` of the configuration, 1 at least
    BinReals wng;                 // white noise gain
    float signal = 0, noise = 0;  // of the beam, smoothed
    Grid<cfloat> weights;         // [mic][bin]
  };

  [[nodiscard]] float memory() const noexcept;
  [[nodiscard]] float step_of(float seconds) const noexcept;
  void forget_room() noexcept;
  void hear(GridView<const cfloat> spectra) noexcept;
  void follow(std::size_t s, const Track& track) noexcept;
  void steer(Slot& slot, Vec3 direction) noexcept;
  void turn(Slot& slot, std::size_t reference) noexcept;
  void begin(Slot& slot) noexcept;
  void look_ahead(std::size_t s) noexcept;
  void learn(std::size_t s) noexcept;
  void begin_with_noise(Slot& slot) noexcept;
  void add_known_noise(Slot& slot) noexcept;
  void load(Slot& slot) noexcept;
  void solve(Slot& slot) noexcept;
  void form(std::size_t s, std::span<cfloat> beam) noexcept;
  void measure(std::size_t s, std::span<const cfloat> beam) noexcept;
  [[nodiscard]] float gain_of(const Slot& slot, std::size_t bin) const noexcept;

  Criterion criterion_;
  AdaptiveConfig config_;
  std::size_t mics_, bins_;
  float hop_seconds_;
  float step_ = 1;    // a, in this hop
  float share_step_;  // the same of the share, which nobody's walking changes
  float least_;       // the smallest white noise gain, as a ratio
  Steering steering_;
  TalkerMasks masks_;
  Stillness stillness_;
  const NoiseField* known_ = nullptr;
  std::vector<Slot> slots_;
  std::vector<BinReals> powers_;  // [slot]: of the beams, unit gain, smoothed
  std::size_t hop_ = 0;
  BinBlocks x_, v_, row_, old_;
  BinReals finite_;      // 1 or 0
  BinReals power_;       // of a microphone, mean
  BinReals background_;  // the same, over the last second
  BinReals smooth_, floor_;
  BinReals keep_, gain_, norm_;
  std::vector<float> gains_;
  std::vector<cfloat> ray_;
};

}  // namespace odas
