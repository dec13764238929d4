// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "odas/base/field.hpp"

namespace odas {

/// One Gaussian of the mixtures p(E | active) and p(E | inactive).
struct GaussianConfig {
  float weight = 1;
  float mu = 0;
  float sigma2 = 0.0025F;
  static Schema schema();
};

/// A direction that is always followed: `sst.target[i]`.
struct TargetConfig {
  std::string tag;
  float x = 0, y = 0, z = 1;
  static Schema schema();
};

struct KalmanConfig {
  float sigma_q = 0.001F;
  static Schema schema();
};

struct ParticleConfig {
  int n_particles = 1000;
  float st_alpha = 2, st_beta = 0.04F, st_ratio = 0.5F;
  float ve_alpha = 0.05F, ve_beta = 0.2F, ve_ratio = 0.3F;
  float ac_alpha = 0.5F, ac_beta = 0.2F, ac_ratio = 0.2F;
  float n_min = 0.7F;
  static Schema schema();
};

/// Tracking: section `sst`.
struct SstConfig {
  std::string mode = "kalman";
  std::string add = "dynamic";
  std::vector<GaussianConfig> active{{1, 0.4F, 0.0025F}};
  std::vector<GaussianConfig> inactive{{1, 0.25F, 0.0025F}};
  float sigma_r2_prob = 0.0025F;
  float sigma_r2_active = 0.0225F;
  float sigma_r2_target = 0.0025F;
  float p_false = 0.1F;
  float p_new = 0.1F;
  float p_track = 0.8F;
  float theta_new = 0.9F;
  int n_prob = 5;
  float theta_prob = 0.8F;
  int n_tracks = 0;
  std::vector<int> n_inactive{150, 200, 250, 250};
  float theta_inactive = 0.9F;
  float memory = 0;
  KalmanConfig kalman;
  ParticleConfig particle;
  std::vector<TargetConfig> target;

  [[nodiscard]] std::size_t slots() const noexcept {
    return n_tracks > 0 ? static_cast<std::size_t>(n_tracks) : n_inactive.size();
  }
  /// Silent hops that an active track survives when so many tracks live; the last number holds for more.
  [[nodiscard]] int patience(std::size_t living) const noexcept {
    return n_inactive[std::min(living, n_inactive.size()) - 1];
  }
  static Schema schema();
};

}  // namespace odas
