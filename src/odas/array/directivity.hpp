// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/base/vec3.hpp"

namespace odas {

/// Gain against the angle from an axis: 1 up to `full` degrees, 0 from `none` on, a sigmoid between,
/// looked up in a table of `n_thetas` points over 0..180 degrees (Grondin and Michaud, 2019, eq. 12).
class GainLaw {
 public:
  GainLaw(Vec3 axis, float full_deg, float none_deg, int n_thetas);

  [[nodiscard]] float operator()(Vec3 direction) const noexcept;

 private:
  Vec3 axis_;
  float step_;  // degrees
  std::vector<float> table_;
};

/// What each microphone, and the listener's spatial filters, let pass from where.
class Directivity {
 public:
  /// Takes the half sphere for spatial filter where none are configured and the array is flat.
  explicit Directivity(const GeneralConfig& config);

  /// The microphone alone.
  [[nodiscard]] float mic(std::size_t m, Vec3 direction) const noexcept { return mics_[m](direction); }
  /// The product of all spatial filters; 1 where there are none.
  [[nodiscard]] float filters(Vec3 direction) const noexcept;
  /// True when the half sphere was chosen because the array is flat.
  [[nodiscard]] bool half_sphere() const noexcept { return half_sphere_; }

 private:
  std::vector<GainLaw> mics_;
  std::vector<GainLaw> filters_;
  bool half_sphere_ = false;
};

}  // namespace odas
