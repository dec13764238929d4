// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/base/grid.hpp"
#include "odas/separation/config.hpp"
#include "odas/separation/post_filter.hpp"
#include "odas/separation/presence_noise.hpp"

namespace odas {

/// Post-filter by masks (`mask`): takes out of a beam the noise and what leaks into it from the other voices,
/// no more than Gmin says.
///
/// Method, per slot s and bin: N = L_s + sum over the others j of e_sj Q_j, L: PresenceNoise of the beam;
///   Q_j: power of voice j, m_j |y_j|^2, which rises at once and falls within 16 ms; e_sj: how much of voice
///   j is in beam s, learned where j is alone: sum w (|y_s|^2 - L_s) / sum w m_j |y_j|^2 over half a second,
///   w = m_j^2; at most 1. Then xi = a S / N + (1 - a) max(|y|^2 / N - 1, 0), decision-directed, S: power of
///   what came out in the hop before; G: least error of the log spectrum, xi / (1 + xi) exp(E1(v) / 2), v =
///   xi / (1 + xi) |y|^2 / N.
/// Symbols: m: share of the talker in this bin, by the beamformer's mask, or where it has none by the power
/// of its beam
///   among that of all beams; y: beams.
/// Source: Ephraim and Malah, "Speech enhancement using a minimum mean-square error log-spectral amplitude
///   estimator", IEEE TASSP 33(2), 1985; the leakage: Valin, Rouat and Michaud, "Enhanced robot audition
///   based on microphone array source separation with post-filter", IROS 2004, whose one constant is measured
///   here for each pair of voices and bin. Departs: exp(E1(v) / 2) is a root of a ratio of polynomials,
///   within 2 %.
/// Shapes: see PostFilter. Delay: none. Cost per hop: bins x (slots^2 x 10 + slots x 60) operations.
/// Errors: a bin that is not finite gives silence, and leaves what is remembered nearly as it is.
/// Fails: sound that is as steady as a noise is taken for one. Two voices that never are alone leak as `leak`
/// says.
class MaskFilter final : public PostFilter {
 public:
  MaskFilter(const MaskFilterConfig& config, const GeneralConfig& general, std::size_t slots);

  void apply(GridView<const cfloat> spectra, GridView<const float> noise_psd, std::span<const Track> tracks,
             const Beamformer& beamformer, GridView<const cfloat> beams,
             GridView<cfloat> filtered) noexcept override;
  [[nodiscard]] bool needs_noise() const noexcept override { return false; }
  void reset() noexcept override;

 private:
  void follow(std::span<const Track> tracks) noexcept;
  void begin(std::size_t slot) noexcept;
  void measure(GridView<const cfloat> spectra, GridView<const cfloat> beams) noexcept;
  void find_voices(const Beamformer& beamformer) noexcept;
  void add_leakage(std::size_t slot) noexcept;
  void shape(std::size_t slot) noexcept;

  MaskFilterConfig config_;
  float leak_step_, fall_, trust_;
  std::vector<std::uint64_t> ids_;    // [slot]: whom all that is remembered belongs to
  PresenceNoise room_;                // of the first microphone: what a new voice begins with
  std::vector<PresenceNoise> noise_;  // [slot]
  Grid<float> power_;                 // [slot][bin]: of the beams, this hop
  Grid<float> mask_;                  // [slot][bin]
  Grid<float> voice_;                 // [slot][bin]: Q
  Grid<float> alone_;                 // [slot][bin]: sum of the voice where it is alone
  Grid<float> leaked_;                // [slot * slots + other][bin]: the same of the beam `slot`
  Grid<float> clean_;                 // [slot][bin]: S
  Grid<float> gains_;                 // [slot][bin]
  std::vector<float> disturbing_;     // [bin]: N
};

/// exp(E1(v) / 2), within 2 % for v > 0.
[[nodiscard]] float log_spectral_gain(float v) noexcept;

}  // namespace odas
