// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// Which bins of a hop tell where a source is: those that stand out of the noise and out of the echoes of
/// what was heard before, for there the direct path is alone. The higher ones count more: they tell more.
///
/// Method, per bin, P = mean |X|^2 and lambda = mean noise power over the microphones:
///   g = max(0, 1 - (c lambda + r) / P) f / f_N,   c = 1 + 4 / sqrt(microphones),
///   r <- d max(r, P), d = 60 dB in 0.5 s: the echo that a room of that reverberation time may have left.
/// Of noise alone P is about exponentially distributed, so that e^-c of the bins pass, and those hardly
/// count. Source: the precedence effect, as in Faller and Merimaa, 2004; the weight is a power subtraction of
/// noise and late reverberation (Lebart et al., 2001). Departs: bins below 200 Hz are left out (no array of
/// ours hears a direction there). Errors: a bin that is not finite counts for nothing and is not remembered.
class OnsetGate {
 public:
  OnsetGate(std::size_t mics, std::size_t bins, float hop_s, float bin_hz);

  /// Makes the weights of a hop; spectra, noise_psd [mic][bin].
  void update(GridView<const cfloat> spectra, GridView<const float> noise_psd) noexcept;
  [[nodiscard]] std::span<const float> weights() const noexcept { return weights_; }
  /// What of them the diffuse rest of noise and echoes makes: g (2.5 lambda + r) / P. More than the noise,
  /// for it pulls at the phases of bins that stand little out of it by more than its share; so measured.
  [[nodiscard]] std::span<const float> diffuse() const noexcept { return diffuse_; }
  void reset() noexcept;

 private:
  float over_noise_;                  // c
  float decay_;                       // of an echo, per hop
  std::vector<float> slope_;          // [bin]: what it counts where it is clear
  std::vector<float> echo_;           // [bin]: r
  std::vector<float> weights_;        // [bin]: g
  std::vector<float> diffuse_;        // [bin]: of weights_
  std::vector<float> power_, noise_;  // [bin]: sums over the microphones
};

}  // namespace odas
