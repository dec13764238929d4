// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "odas/base/field.hpp"

namespace odas {

/// One level of the coarse-to-fine search: `ssl.scans[i]`.
struct ScanConfig {
  int level = 2;
  int delta = -1;  // half-width of the sliding maximum in interpolated samples; < 0: automatic, per pair
  static Schema schema();
};

/// Localization: section `ssl`.
struct SslConfig {
  std::string mode = "srp_phat";
  int n_pots = 4;
  int n_matches = 10;
  float prob_min = 0.5F;
  int n_refined_levels = 1;
  int interp_rate = 4;
  std::vector<ScanConfig> scans{{2, -1}, {4, -1}};
  std::string weighting = "none";
  float averaging = 55;  // ms
  static Schema schema();
};

}  // namespace odas
