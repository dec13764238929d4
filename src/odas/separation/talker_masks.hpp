// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/separation/bin_blocks.hpp"
#include "odas/separation/steering.hpp"

namespace odas {

/// Who is heard in each bin: a share for each talker, and one for sound from everywhere.
///
/// Method: a talker's sound has covariance (1 - eps) d d^H + eps G, diffuse sound G; a bin's likelihood is
/// the
///   complex angular central Gaussian, 1 / (det R (x^H R^-1 x)^M), tempered by 2 / M so that arrays of any
///   size are as sure. Times the square of what the talker's beam gives in this bin, times how much of the
///   whole spectrum is the talker's:
///     s_k = pi_k (P_k / ((1 - c_k r_k) (1 + A_k)^(1/M)))^2,  s_0 = pi_0 P_0^2,  mask_k = s_k / sum s
///     r_k = |d^H G^-1 x|^2 / (d^H G^-1 d  x^H G^-1 x),  A_k = (1 - eps) / eps d^H G^-1 d,  c_k = A / (1 + A)
///   and, over frequency, three bins smoothed. The directions hold the identities: no bin can change talkers.
/// Symbols: d: steering of a talker; G: diffuse coherence, with some white noise; P_k: power of the talker's
///   beam, P_0: harmonic mean of these and the
///   noise floor; pi: shares of the last hops over all bins (they tie the bins together).
/// Source: Ito, Araki and Nakatani, "Complex angular central Gaussian mixture model for directional
/// statistics
///   in mask-based microphone array signal processing", 2016; the shares over all bins: same,
///   "Permutation-free clustering of relative transfer function features for blind source separation", 2015.
///   The beams' powers are this program's.
/// Shapes: x [mic] of each bin; powers and masks [slot] of each bin.
/// Cost per hop: bins x (mics^2 / 2 + slots x mics) complex products.
/// Fails: talkers closer than the array's resolution share their bins; one who stands elsewhere than tracked
///   counts as diffuse.
class TalkerMasks {
 public:
  TalkerMasks(const GeneralConfig& general, std::size_t slots);

  /// Slot `slot` listens to `steering` [mic] from now on.
  void listen(std::size_t slot, const BinBlocks& steering) noexcept;
  void leave(std::size_t slot) noexcept;

  /// `powers` [slot] are read for slots that listen; `floor`: power of the steady noise.
  void update(const BinBlocks& x, std::span<const BinReals> powers, const BinReals& floor) noexcept;

  [[nodiscard]] const BinReals& mask(std::size_t slot) const noexcept { return masks_[slot]; }
  /// L of G = L L^H.
  [[nodiscard]] const BinBlocks& diffuse_factor() const noexcept { return diffuse_; }

  void reset() noexcept;

 private:
  struct Look {
    bool listens = false;
    float share = 0;     // pi
    BinBlocks pattern;   // L^-1 d / |L^-1 d|
    BinReals surety;     // c
    BinReals narrowing;  // (1 + A)^(-1/M)
    BinReals score;      // P_k / ...
  };

  void score(Look& look, const BinReals& power) noexcept;
  void share(std::span<const float> loudness) noexcept;

  std::size_t mics_, bins_;
  BinBlocks diffuse_;
  std::vector<Look> looks_;
  float diffuse_share_ = 0;
  std::vector<BinReals> masks_;
  BinBlocks whitened_;  // L^-1 x
  BinBlocks match_;     // one row
  BinReals energy_;     // x^H G^-1 x
  BinReals diffuse_score_, sum_, loudness_, smoothed_;
};

/// Cholesky factors of the coherence of sound from everywhere: sinc(2 f distance / c), with `white` of white
/// noise.
[[nodiscard]] BinBlocks diffuse_factor(const GeneralConfig& general, float white);

}  // namespace odas
