// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/directivity.hpp"
#include "odas/array/geometry.hpp"
#include "odas/base/vec3.hpp"

namespace odas {

/// How exactly an array can tell directions, from its geometry alone.
///
/// Method: each pair (i, j) that hears a direction u measures the TDoA (p_j - p_i) . u / c with an error of
/// deviation `tdoa_error_s`, apart from the others. The Fisher information of u in the tangent plane is
/// J = sum (d_t d_t^T) / (c sigma)^2, d_t the part of p_i - p_j across u; its inverse bounds the covariance
/// of any unbiased estimate (Cramer and Rao). Pairs share microphones, so the bound is a little too good; it
/// ranks arrays and directions, and is about what a quiet room without echo gives.
class DoaError {
 public:
  DoaError(const GeneralConfig& general, double tdoa_error_s);

  struct At {
    Vec3 direction;
    std::size_t pairs = 0;   // that hear it
    double azimuth_deg = 0;  // deviation, on the sphere: an azimuth near the pole counts little
    double elevation_deg = 0;
    /// Of the angle between the estimate and the truth.
    [[nodiscard]] double angle_deg() const noexcept;
  };
  /// Nothing where no pair hears the direction. Deviations are at most 90 degrees: nothing is known then.
  [[nodiscard]] std::optional<At> at(Vec3 direction) const;

  /// Two directions that the array cannot tell apart: all TDoAs of the pairs that hear both differ by less
  /// than twice the error, though the directions are far from each other.
  struct Ambiguity {
    Vec3 a, b;
    [[nodiscard]] double apart_deg() const noexcept;
  };
  /// Among these directions, at least `least_deg` apart; the furthest first, at most `most` of them.
  [[nodiscard]] std::vector<Ambiguity> ambiguities(std::span<const Vec3> directions, double least_deg,
                                                   std::size_t most) const;

 private:
  /// The gain of each microphone towards a direction.
  [[nodiscard]] std::vector<float> gains(Vec3 direction) const;
  [[nodiscard]] bool hears(const Pair& pair, const std::vector<float>& gains) const noexcept;

  std::vector<Vec3> positions_;
  std::vector<Pair> pairs_;
  Directivity directivity_;
  float gain_min_;
  double distance_error_;  // c sigma, m
};

/// What the shape of an array means in words.
enum class ArrayShape { point, line, plane, volume };
[[nodiscard]] ArrayShape shape_of(std::span<const MicConfig> mics) noexcept;

}  // namespace odas
