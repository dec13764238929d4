// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "odas/array/types.hpp"

namespace odas {

/// What a beamformer says of its work for one slot. NaN: not known.
struct BeamReport {
  float snr_db = 0;               // of the beam: its talker against all else, over the last second
  float white_noise_gain_db = 0;  // against white noise in the microphones, mean over the bins, dB
  float condition_db = 0;  // of the covariance of all else, 10 log10 of the ratio of the extremes of its
                           // Cholesky diagonal, squared; mean over the bins
  std::uint64_t id = 0;    // of the track that it is about; 0: none. Filled in by the pipeline
};

/// White-noise gain of the weights [mic][bin] where their talker passes with gain 1: the mean over the bins
/// of 10 log10(1 / sum over mics of |W_m|^2). NaN where all weights are 0.
[[nodiscard]] float white_noise_gain_db(GridView<const cfloat> weights) noexcept;

}  // namespace odas
