// SPDX-License-Identifier: MIT
#pragma once

#include "odas/array/config.hpp"
#include "odas/classification/config.hpp"
#include "odas/dsp/mcra_config.hpp"
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
};

/// All that the pipeline needs to know: the sections general, sne, ssl, sst, sss of the configuration.
struct PipelineConfig {
  GeneralConfig general;
  McraConfig sne;
  SslConfig ssl;
  SstConfig sst;
  SssConfig sss;
  ClassifyConfig classify;
  Wanted wanted;
};

}  // namespace odas
