// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "odas/localization/diffuse_field.hpp"
#include "odas/localization/kernels.hpp"
#include "odas/localization/localizer.hpp"
#include "odas/localization/onset_gate.hpp"
#include "odas/localization/peak_fit.hpp"
#include "odas/localization/peak_search.hpp"
#include "odas/localization/search_plan.hpp"

namespace odas {

/// Steered response power of averaged, gated cross-correlations, from which each found source's own pattern
/// is subtracted before the next is searched (CLEAN).
///
/// Method: g = weights of the hop's bins (OnsetGate);
///   x_ij <- (1 - a) x_ij + a IDFT(g phi_i conj(phi_j) - diffuse part),  w <- (1 - a) w + a IDFT(g),
///   phi = X / |X|,  a = 1 - e^(-(1 + 60 m) hop / averaging),  m: mean of g over the bins. A clear hop needs
///   no average, and what was before is not mixed into it. The diffuse part is DiffuseField's. Search from
///   coarse to fine (PeakSearch), then off the grid (PeakFit). After a potential at u with E is found:
///   x_ij[l] -= E w[l - lag_ij(u)] / w[0].
///   energy = E: 0.5 if all bins were clear onsets of one plane wave. evidence and covariance: below, fitted
///   to simulated rooms; docs/localization.md has the figures.
/// Symbols: u direction, i < j microphones, l lag in samples interpolated r times.
/// Source: SRP-PHAT, DiBiase, 2000; search, Grondin and Michaud, 2019; CLEAN, Hoegbom, 1974.
/// Shapes: spectra [mic][bin], noise_psd [mic][bin] -> potentials, the clearest first.
/// Cost per hop: pairs (bins with g > 0, about an eighth of all, x lags / 2 + potentials (candidates +
/// lags)). Delay: none, but an average lags by its time constant at most. Errors: the constructor throws
/// ConfigError. A non-finite bin counts as silent. Fails: a source that sounds steadily for seconds (a hum)
/// is noise. Errors of neighbouring hops are not independent: the average links them.
class SrpClean final : public Localizer {
 public:
  SrpClean(const GeneralConfig& general, const SslConfig& ssl);

  void locate(GridView<const cfloat> spectra, GridView<const float> noise_psd,
              std::span<Potential> potentials) noexcept override;
  [[nodiscard]] bool needs_noise() const noexcept override { return true; }
  void keep_power_map() override { power_.resize(power_grid().size()); }
  [[nodiscard]] std::span<const float> power_map() const noexcept override { return power_; }
  [[nodiscard]] std::span<const Vec3> power_grid() const noexcept override {
    return plan_.levels.front().directions;
  }
  void reset() noexcept override;
  [[nodiscard]] LocalizerPlan plan() const override { return plan_.summary; }

 private:
  void hear(GridView<const cfloat> spectra) noexcept;
  void average() noexcept;
  void subtract(const PeakFit::Fit& fit, std::span<const std::uint8_t> heard) noexcept;
  [[nodiscard]] Potential describe(const PeakFit::Fit& fit, float strongest) const noexcept;
  /// How many hops alike make up the average: 1 after a single click.
  [[nodiscard]] float hops_heard() const noexcept;

  SearchPlan plan_;
  LagTable table_, pattern_table_;
  OnsetGate gate_;
  DiffuseField diffuse_;
  float hops_averaged_;         // averaging / hop
  Grid<float> re_, im_;         // [mic][bin, padded]: sqrt(g) phi
  Grid<float> now_;             // [pair][column]: of this hop
  Grid<float> averaged_;        // [pair][column]
  Grid<float> rest_;            // [pair][column]: what is left when the potentials so far are subtracted
  Grid<float> root_, nothing_;  // [1][bin, padded]: sqrt(g), 0
  Grid<float> pattern_now_, pattern_;  // [1][column]: of this hop; averaged
  std::vector<std::uint16_t> clear_;   // bins with g > 0
  std::vector<float> scratch_;
  float squares_ = 0;  // of what each hop adds to the middle of pattern_, faded as these are
  PeakSearch search_;
  PeakFit fit_;
  std::vector<float> power_;  // [direction of the coarsest grid], if kept
};

}  // namespace odas
