// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"
#include "odas/base/vec3.hpp"
#include "odas/tracking/config.hpp"
#include "odas/tracking/normal_noise.hpp"

namespace odas {

/// A source that moves on the sphere, followed by a cloud of weighted particles: some stand still, some
/// keep their velocity, some accelerate.
///
/// Method: v <- a v + b noise, p <- p + dT A v, a = exp(-alpha dT), b = beta sqrt(1 - a^2), (alpha, beta) by
/// the kind of motion; a particle's weight is multiplied by (1 - A) / n + A q, where A is the source's
/// activity and q how well the particle explains the potential that most likely came from it; when fewer than
/// Nmin n particles count, they are drawn anew. The direction is the weighted mean. Source: Valin, Michaud
/// and Rouat, "Robust localization and tracking of simultaneous moving sound sources using beamforming and
/// particle filtering", 2007, section 5; ODAS. Departures from ODAS, each measured on scenes of crossing and
/// of four talkers:
/// - the cloud is weighed by the likeliest potential alone, as the Kalman filter is: where two talkers cross,
///   the other one's potential does not pull it away;
/// - it moves at the pace A of the last hop: a cloud that spread while its source is silent would reach the
///   other talkers and take them over;
/// - particles stay on the sphere and move in its tangent plane, as the paper has it;
/// - they are drawn anew systematically (one random number for all of them: less noise than one for each);
/// - noise comes from a seeded generator of the filter's own, and `start` seeds it: same input, same bits.
/// Shapes: nParticles, rounded up to a multiple of four.
/// Cost per hop, N particles, S potentials: N (S + 1) exponentials, less those of potentials that are far
/// off, and 6 N random words; `docs/tracking.md` has the time. Allocates only when constructed.
/// Fails: where a source moves faster than the particles that accelerate (ac_beta radians/s) can.
class Particle {
 public:
  Particle(const ParticleConfig& config, double hop_seconds);

  void start(Vec3 direction) noexcept;
  void predict() noexcept;
  /// log sum_i w_i N(z; p_i, sigma2 I): how well an observation of variance `sigma2` fits. Fits worse than
  /// exp(-20) of the best are not told apart.
  [[nodiscard]] double log_likelihood(Vec3 z, double sigma2) const noexcept;
  /// `probability[s]` that potential s came from this source; `activity` that any did.
  void update(std::span<const Potential> potentials, std::span<const double> probability, double activity,
              double sigma2) noexcept;
  [[nodiscard]] Vec3 direction() const noexcept { return direction_; }

 private:
  /// Four particles side by side.
  struct Group {
    Floats x, y, z, vx, vy, vz, weight;
    Floats fit;  // q, while `update` runs
  };
  struct Motion {
    float damping, excitation;  // a, b
    std::size_t end;            // the groups up to here move so
  };

  static Floats fit_of(const Group& group, Vec3 z, float precision) noexcept;
  void estimate() noexcept;
  void draw_anew() noexcept;

  float dt_;
  float pace_ = 1;  // activity of the last hop
  float fewest_;    // effective particles
  std::array<Motion, 3> motions_{};
  NormalNoise noise_;
  std::vector<Group> groups_, drawn_;
  std::size_t stride_;   // from one drawn particle's place to the next one's
  float radius_ = 0;     // no particle is farther from direction_
  float effective_ = 0;  // 1 / sum of squared weights
  Vec3 direction_{0, 0, 1};
};

}  // namespace odas
