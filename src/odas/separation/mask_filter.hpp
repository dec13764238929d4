// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/separation/config.hpp"
#include "odas/separation/post_filter.hpp"

namespace odas {

/// Post-filter by masks (`mask`): takes out of a beam what is not its talker's, no more than Gmin says.
///
/// Method, per slot and bin: G = max(m / (m + leak (1 - m)), Gmin), m: the share of the talker in this bin,
/// by
///   the beamformer's mask, or where it has none by the power of its beam among that of all beams. Smoothed
///   over neighbouring bins, and over time when it falls: an onset is let through at once.
/// Symbols: leak: how much of the others is still in the beam, as power.
/// Source: the Wiener filter; masks in place of SNRs, as Heymann, Drude and Haeb-Umbach, "Neural network
/// based
///   spectral mask estimation for acoustic beamforming", 2016, with masks that need no training.
/// Shapes: see PostFilter. Delay: none. Cost per hop: slots x bins.
/// Errors: a bin that is not finite gives silence, and leaves what is remembered as it is.
/// Fails: with a beamformer without masks, steady noise beside a single talker stays.
class MaskFilter final : public PostFilter {
 public:
  MaskFilter(const MaskFilterConfig& config, const GeneralConfig& general, std::size_t slots);

  void apply(GridView<const cfloat> spectra, GridView<const float> noise_psd, std::span<const Track> tracks,
             const Beamformer& beamformer, GridView<const cfloat> beams,
             GridView<cfloat> filtered) noexcept override;
  [[nodiscard]] bool needs_noise() const noexcept override { return false; }
  void reset() noexcept override;

 private:
  void measure(std::span<const Track> tracks, GridView<const cfloat> beams) noexcept;
  void shape(std::size_t slot, std::span<const float> mask) noexcept;

  MaskFilterConfig config_;
  std::vector<std::uint64_t> ids_;  // [slot]: whom the powers and gains belong to
  Grid<float> power_;               // [slot][bin]: of the beams, smoothed
  Grid<float> gains_;               // [slot][bin]
  std::vector<float> sum_;          // [bin]: of the powers of all beams
  std::vector<float> raw_;          // [bin]
};

}  // namespace odas
