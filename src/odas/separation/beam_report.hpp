// SPDX-License-Identifier: MIT
#pragma once

namespace odas {

/// What a beamformer says of its work for one slot. NaN: not known.
struct BeamReport {
  float snr_db = 0;               // of the beam: its talker against all else, over the last second
  float white_noise_gain_db = 0;  // against white noise in the microphones, mean over the bins, dB
  float condition_db = 0;  // of the covariance of all else, 10 log10 of the ratio of the extremes of its
                           // Cholesky diagonal, squared; mean over the bins
};

}  // namespace odas
