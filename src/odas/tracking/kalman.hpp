// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "odas/array/types.hpp"
#include "odas/base/vec3.hpp"
#include "odas/tracking/config.hpp"

namespace odas {

/// A source that moves on the sphere at a slowly changing velocity, followed by a Kalman filter.
///
/// Method: state (p, v), p' = p + dT v; p is drawn back onto the sphere and v into its tangent plane after
/// each prediction; the gain is scaled by how probably the source sounds. All noises are alike on the three
/// axes, so the 6x6 covariance is a 2x2 one (pp, pv, vv) times the identity: exact, not an approximation.
/// Source: Grondin and Michaud, 2019, section 4 (M3K).
class Kalman {
 public:
  Kalman(const KalmanConfig& config, double hop_seconds)
      : dt_(hop_seconds), q_(static_cast<double>(config.sigma_q) * static_cast<double>(config.sigma_q)) {}

  void start(Vec3 direction) noexcept;
  void predict() noexcept;
  /// log N(z; p, (pp + sigma2) I): how well an observation of variance `sigma2` fits.
  [[nodiscard]] double log_likelihood(Vec3 z, double sigma2) const noexcept;
  /// `probability[s]` that potential s came from this source; `activity` that any did.
  void update(std::span<const Potential> potentials, std::span<const double> probability, double activity,
              double sigma2) noexcept;
  [[nodiscard]] Vec3 direction() const noexcept;

 private:
  double dt_, q_;
  double p_[3]{}, v_[3]{};
  double pp_ = 0, pv_ = 0, vv_ = 0;  // covariance
};

}  // namespace odas
