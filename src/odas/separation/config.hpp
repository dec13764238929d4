// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/base/field.hpp"

namespace odas {

/// Geometric source separation: `sss.dgss`.
struct GssConfig {
  float mu = 0.01F;
  float lambda = 0.5F;
  static Schema schema();
};

/// The multi-source post-filter: `sss.ms`.
struct MultiSourceFilterConfig {
  float alpha_p_min = 0.07F;
  float eta = 0.5F;
  float alpha_z = 0.8F;
  float theta_win = 0.3F;
  float alpha_win = 0.3F;
  float max_absence_prob = 0.9F;
  float g_min = 0.01F;
  int win_size_local = 3;
  int win_size_global = 23;
  int win_size_frame = 256;
  static Schema schema();
};

/// The single-source post-filter: `sss.ss`.
struct SingleSourceFilterConfig {
  float g_min = 0.01F;
  float g_mid = 0.5F;
  float g_slope = 10;
  static Schema schema();
};

/// The beamformers that learn: `sss.dmvdr`, `sss.dgev`.
struct AdaptiveConfig {
  float memory = 3;           // s
  float loading = 0.003F;     // of the power of all else
  float unexplained = 0.02F;  // of the talker's
  float tradeoff = 2;
  float harm = 8;
  float white_noise_gain = -15;  // dB
  static Schema schema();
};

/// The post-filter by masks: `sss.mask`.
struct MaskFilterConfig {
  float g_min = 0.13F;
  float leak = 0.5F;
  static Schema schema();
};

/// Separation: section `sss`.
struct SssConfig {
  std::string mode_sep = "dds";
  std::string mode_pf = "ss";
  int frame_size = 0;  // samples; 0: that of `general`
  std::string noise;   // file of a NoiseDictionary; empty: none is known
  float lookback = 0;  // ms
  float gain_sep = 1;
  float gain_pf = 1;
  GssConfig dgss;
  MultiSourceFilterConfig ms;
  AdaptiveConfig dmvdr;
  AdaptiveConfig dgev;
  SingleSourceFilterConfig ss;
  MaskFilterConfig mask;
  static Schema schema();
};

}  // namespace odas
