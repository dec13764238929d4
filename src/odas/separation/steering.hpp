// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/directivity.hpp"
#include "odas/array/types.hpp"

namespace odas {

/// How a plane wave from direction u reaches the microphones, against the origin of the array:
///   A_m[k] = g_m(u) exp(+j 2 pi k (fS / N) (p_m . u) / c)
/// p_m: position; g_m: directivity of microphone m; u is taken as it comes, not made a unit vector.
///
/// Cost: one sine and cosine a microphone, then one complex product a bin; the error stays under 1e-6 for
/// any frame, for no product is taken of more than two factors.
class Steering {
 public:
  explicit Steering(const GeneralConfig& general);

  [[nodiscard]] std::size_t mics() const noexcept { return positions_.size(); }
  [[nodiscard]] std::size_t bins() const noexcept { return bins_; }

  /// gains[mic]: g_m(u); 0 where it is less than `general.gainMin`: that microphone does not hear u.
  /// Nobody hears a direction that is not finite.
  void gains(Vec3 u, std::span<float> gains) const noexcept;

  /// row[bin] = gain exp(+j 2 pi k (fS / N) (p_m . u) / c). Its conjugate is the row of -u.
  void row(std::size_t mic, Vec3 u, float gain, std::span<cfloat> row) const noexcept;

 private:
  std::size_t bins_;
  double radians_per_metre_;  // of one bin
  float gain_min_;
  std::vector<Vec3> positions_;
  Directivity directivity_;
};

}  // namespace odas
