// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/dsp/noise_dictionary.hpp"
#include "odas/dsp/noise_model.hpp"

namespace odas {

/// The spatial covariance of the machine's own noise as it is now, from a dictionary of what it was.
///
/// Method: a hop counts as noise where it is as likely under an entry as the hops that the entry was learned
/// from (three standard deviations), whoever is tracked; or where nobody has spoken for a second. From such
/// hops follow the entry D, by smoothed likelihood, one rival being asked in each hop; and its correction:
///   R_live <- R_live + (x x^H - R_live) / n,  n up to one second of hops, from 1 again with each new entry,
///   R = (n R_live + nu g D) / (n + nu),  nu = 2 M,  g: the power now against that of D,
/// so that one hop suffices to choose, and a second to follow what was not learned. Hops that are not as
/// learned move R_live slowly (8 s), for they may be somebody's first word.
/// Symbols: x: spectra of a hop; M: microphones.
/// Source: Lagace, Ferland and Grondin, 2023 (the dictionary, NoiseLearner). Departs: the entry is chosen by
///   the likelihood of what is heard, and corrected in pauses as the mean of an inverse Wishart.
/// Shapes: spectra [mic][bin]. Units: power of unscaled, root-Hann windowed spectra.
/// Cost per hop: likelihood of two entries, M^2 products a bin; an eighth of the bins is renewed: M^3 / 48.
/// Delay: up to 8 hops until a bin is renewed.
/// Errors: a hop that is not finite or is silent changes nothing.
/// Fails: where the machine or its microphones have been rebuilt since: learn again.
class NoiseField {
 public:
  /// `dictionary` is not empty.
  explicit NoiseField(NoiseDictionary dictionary);

  /// Once a hop. `somebody_speaks`: a source other than the machine is followed and sounds.
  void update(GridView<const cfloat> spectra, bool somebody_speaks) noexcept;

  /// [mic][mic]: E[x x^H], of full rank.
  [[nodiscard]] GridView<const cfloat> scm(std::size_t bin) const noexcept;
  /// [mic][bin]: column j of the Cholesky factor, so that scm = sum over j of column_j column_j^H.
  [[nodiscard]] GridView<const cfloat> column(std::size_t j) const noexcept { return columns_[j]; }
  /// The entry that fits now.
  [[nodiscard]] std::size_t entry() const noexcept { return entry_; }
  /// Whether the last hop counted as the machine's noise alone.
  [[nodiscard]] bool heard_noise() const noexcept { return heard_noise_; }

  /// The state after construction, exactly.
  void reset() noexcept;

 private:
  [[nodiscard]] bool choose(GridView<const cfloat> spectra) noexcept;
  void follow(GridView<const cfloat> spectra, float gain) noexcept;
  void renew(std::size_t bin) noexcept;

  NoiseDictionary dictionary_;
  std::size_t mics_, bins_;
  float second_;                    // hops
  std::vector<NoiseModel> models_;  // [entry]
  std::vector<float> scores_;       // [entry]: likeness, smoothed
  std::size_t entry_ = 0, rival_ = 0;
  float heard_ = 0;       // n
  float quiet_for_ = 0;   // hops in which nobody spoke
  std::size_t turn_ = 0;  // which bins are renewed
  bool heard_noise_ = false;
  std::vector<cfloat> live_, field_, factor_;  // [bin][mic][mic]; factor_: of one bin
  std::vector<Grid<cfloat>> columns_;          // [column][mic][bin]
};

}  // namespace odas
