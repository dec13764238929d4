// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "odas/array/config.hpp"
#include "odas/classification/config.hpp"
#include "odas/dsp/mcra_config.hpp"
#include "odas/dsp/noise_dictionary.hpp"
#include "odas/localization/config.hpp"
#include "odas/separation/config.hpp"
#include "odas/tracking/config.hpp"

namespace odas {

/// What somebody listens to. What nobody does is not computed (nor is what only it needs).
struct Wanted {
  bool potentials = true;
  bool tracks = true;
  bool separated = true;
  bool postfiltered = true;
  bool categories = false;  // the classes of the tracks: asked for expressly, since they need the voices
  // Asked for expressly, too:
  bool mics = false;       // the microphones themselves, as the pipeline heard them
  bool power_map = false;  // the energy of every direction of the coarsest grid
  bool reports = false;    // of the beams

  friend bool operator==(const Wanted&, const Wanted&) = default;
};

/// All that the pipeline needs to know: the sections general, sne, ssl, sst, sss of the configuration.
struct PipelineConfig {
  GeneralConfig general;
  McraConfig sne;
  SslConfig ssl;
  SstConfig sst;
  SssConfig sss;
  ClassifyConfig classify;
  NoiseDictionary known_noise;  // what sss.noise names; empty: none
  Wanted wanted;
};

/// `sss.lookback` in whole hops, the nearest number.
[[nodiscard]] std::size_t lookback_hops(const PipelineConfig& config);

/// The frame of separation, samples: `sss.frameSize`, or that of all stages where it has none of its own;
/// even.
[[nodiscard]] std::size_t separation_frame(const PipelineConfig& config);

/// By how much separated and post-filtered audio comes later than the microphones, s: hop n of the audio
/// ends with the sound that the microphones heard this long before the end of hop n. For the overlap of the
/// frames, and for the look-back.
[[nodiscard]] double voice_delay_s(const PipelineConfig& config);

}  // namespace odas
