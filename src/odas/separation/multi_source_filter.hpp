// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/dsp/mcra_config.hpp"
#include "odas/dsp/noise_estimator.hpp"
#include "odas/separation/config.hpp"
#include "odas/separation/hann_smoother.hpp"
#include "odas/separation/post_filter.hpp"

namespace odas {

/// Multi-source post-filter (`ms`): takes steady noise, and what leaks from the other sources, out of a beam.
///
/// Method, per slot and bin, P = |y|^2:
///   noise: lambda = MCRA(P) + eta sum over other slots of Z, Z <- (1 - alphaZ) Z + alphaZ P;
///   g = P / lambda, a = min((xi / (1 + xi))^2 + alphaPmin, 1), xi <- (1 - a) G1^2 g + a max(g - 1, 0);
///   v = g xi / (1 + xi), G1 = min(xi / (1 + xi) exp(E1(v) / 2), 1);
///   zeta_i <- (1 - alphaWin) zeta_i + alphaWin (h_i * xi) for a local, a global and a frame window h_i,
///   P_i = zeta_i^2 / (zeta_i^2 + thetaWin^2), q = min(1 - P_local P_global P_frame, maxAbsenceProb),
///   p = 1 / (1 + q / (1 - q) (1 + xi) exp(-v)), G = G1^p Gmin^(1 - p).
/// Symbols: xi, g: a priori and a posteriori SNR; G1: gain where speech is present; p: probability of that.
/// Source: Valin, Rouat and Michaud, "Enhanced robot audition based on microphone array source separation
/// with
///   post-filter", 2004; Ephraim and Malah, 1985 (log-spectral amplitude); Cohen and Berdugo, 2001; ODAS 9.5.
///   Departs from ODAS: maxAbsenceProb is read (there it is 0.9, fault B17); the noise has an estimate from
///   the first hop (Mcra); exp(E1(v) / 2) is exact (there a table, within 0.2 %); SNRs are held under 100 dB.
/// Shapes: see PostFilter. Delay: none. Cost per hop: slots x bins, with two exponentials and a logarithm
/// each. Errors: a beam that is not finite gives silence, and leaves what is remembered as it is. Fails:
/// musical noise where thetaWin is too small; a source beside a much louder one is taken for leakage.
class MultiSourceFilter : public PostFilter {
 public:
  MultiSourceFilter(const MultiSourceFilterConfig& config, const McraConfig& sne,
                    const GeneralConfig& general, std::size_t slots);

  /// 100 dB: more says nothing, and would stay in the averages for long.
  static constexpr float kLargestSnr = 1e10F;
  /// `noise`: how the noise of a beam is followed, in place of Mcra; of the shape [slot][bin].
  MultiSourceFilter(const MultiSourceFilterConfig& config, std::unique_ptr<NoiseEstimator> noise,
                    const GeneralConfig& general, std::size_t slots, float largest_snr = kLargestSnr);

  void apply(GridView<const cfloat> spectra, GridView<const float> noise_psd, std::span<const Track> tracks,
             const Beamformer& beamformer, GridView<const cfloat> beams,
             GridView<cfloat> filtered) noexcept override;
  [[nodiscard]] bool needs_noise() const noexcept override { return true; }
  void reset() noexcept override;

 protected:
  /// h * xi. Virtual for one test alone, that of ODAS's rounding.
  virtual void smooth(HannSmoother& window, std::span<const float> xi, std::span<float> smoothed) noexcept {
    window.smooth(xi, smoothed);
  }

 private:
  struct Window {
    HannSmoother smoother;
    Grid<float> presence;  // zeta [slot][bin]
  };

  void begin(std::size_t slot, GridView<const float> noise_psd, const Beamformer& beamformer) noexcept;
  void forget(std::size_t slot) noexcept;
  void estimate_noise(std::size_t slot) noexcept;
  void estimate_snr(std::size_t slot) noexcept;
  void estimate_gain(std::size_t slot) noexcept;
  [[nodiscard]] float phi(float v) const noexcept;

  MultiSourceFilterConfig config_;
  float epsilon_, largest_snr_;
  std::unique_ptr<NoiseEstimator> noise_;  // of the beams, [slot][bin]
  std::vector<Window> windows_;            // local, global, frame
  std::vector<float> phi_table_;           // sqrt(v) exp(E1(v) / 2)
  std::vector<std::uint64_t> ids_;         // [slot]: whom the states belong to
  std::vector<bool> heard_;                // [slot]: live, and finite in this hop
  Grid<float> power_;                      // P [slot][bin]
  Grid<float> leak_;                       // Z [slot][bin]
  Grid<float> snr_;                        // xi [slot][bin]
  Grid<float> present_gain_;               // G1 [slot][bin]
  std::vector<float> interference_;        // lambda [bin]
  std::vector<float> v_;                   // v [bin]
  std::vector<float> presence_;            // P_local P_global P_frame [bin]
  std::vector<float> smoothed_;            // [bin]
  std::vector<float> gain_;                // G [bin]
};

}  // namespace odas
