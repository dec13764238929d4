// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "odas/localization/kernels.hpp"
#include "odas/localization/localizer.hpp"
#include "odas/localization/peak_search.hpp"
#include "odas/localization/search_plan.hpp"
#include "odas/localization/snr_weights.hpp"

namespace odas {

/// Steered response power with phase transform, searched from coarse to fine (SRP-PHAT-HSDA).
///
/// Method: phi_m = g_m X_m / (|X_m| + eps); x_ij[l] = inverse DFT of phi_i conj(phi_j); E(u) = mean over the
/// pairs that hear u of max over |k| <= delta of x_ij[lag_ij(u) + k]. The coarsest level is searched whole,
/// each finer one around its winner. After a potential is found its peak is cut out of every correlation, and
/// the search begins anew. g is 1, or the a-priori weight of the signal-to-noise ratio (SnrWeights).
/// Symbols: u direction, i < j microphones, l lag in samples interpolated r times.
/// Source: Grondin and Michaud, 2019, algorithms 1-4; ODAS paper, 2022, section 2.1.
/// Departures: only the lags that are read are computed; the best candidate wins even when all correlations
/// are negative (ODAS then reported a direction of the wrong grid).
/// Shapes: spectra [mic][bin] -> potentials, E = 1 for a coherent plane wave on the grid.
/// Cost per hop: pairs (bins x lags / 2 + potentials x candidates). Delay: none.
/// Errors: the constructor throws ConfigError. A non-finite bin counts as silent.
/// Fails: where the aperture spans more than half a frame of sound, lags wrap around.
class SrpPhat final : public Localizer {
 public:
  SrpPhat(const GeneralConfig& general, const SslConfig& ssl);

  void locate(GridView<const cfloat> spectra, GridView<const float> noise_psd,
              std::span<Potential> potentials) noexcept override;
  [[nodiscard]] bool needs_noise() const noexcept override { return weights_.has_value(); }
  void keep_power_map() override { power_.resize(power_grid().size()); }
  [[nodiscard]] std::span<const float> power_map() const noexcept override { return power_; }
  [[nodiscard]] std::span<const Vec3> power_grid() const noexcept override {
    return plan_.levels.front().directions;
  }
  void reset() noexcept override;
  [[nodiscard]] LocalizerPlan plan() const override { return plan_.summary; }

 private:
  void whiten(GridView<const cfloat> spectra) noexcept;
  void cut_out(std::size_t point) noexcept;

  float epsilon_;
  SearchPlan plan_;
  LagTable table_;
  std::optional<SnrWeights> weights_;
  Grid<float> re_, im_;       // [mic][bin, padded]: the whitened spectra
  Grid<float> correlations_;  // [pair][column]
  std::vector<float> scratch_;
  PeakSearch search_;
  std::vector<float> power_;  // [direction of the coarsest grid], if kept
};

}  // namespace odas
