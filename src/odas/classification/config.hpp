// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/base/field.hpp"

namespace odas {

/// Speech or not, by pitch: section `classify`.
struct ClassifyConfig {
  std::string mode = "pitch";
  int frame_size = 1024;
  int win_size = 3;
  float tau_min = 32;
  float tau_max = 200;
  float delta_tau_max = 7;
  float alpha = 0.3F;
  float gamma = 0.05F;
  float phi_min = 0.15F;
  float r0 = 0.2F;
  bool in_tracks = false;
  float voicing_min = 0;
  static Schema schema();
};

}  // namespace odas
