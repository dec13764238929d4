// SPDX-License-Identifier: MIT
#include "odas/array/directivity.hpp"

#include <algorithm>
#include <cmath>

#include "odas/array/geometry.hpp"

namespace odas {
namespace {

Vec3 vec3(const std::array<float, 3>& a) noexcept { return {a[0], a[1], a[2]}; }

}  // namespace

GainLaw::GainLaw(Vec3 axis, float full_deg, float none_deg, int n_thetas)
    : axis_(axis),
      step_(180.F / static_cast<float>(n_thetas - 1)),
      table_(static_cast<std::size_t>(n_thetas)) {
  for (std::size_t t = 0; t < table_.size(); ++t) {
    const float theta = static_cast<float>(t) * step_;
    if (theta <= full_deg) {
      table_[t] = 1;
    } else if (theta >= none_deg) {
      table_[t] = 0;
    } else {
      const float slope = 20 / (none_deg - full_deg);
      table_[t] = 1 / (1 + std::exp(slope * (theta - (full_deg + none_deg) / 2)));
    }
  }
}

float GainLaw::operator()(Vec3 direction) const noexcept {
  const float cosine = dot(axis_, direction) / (norm(axis_) * norm(direction));
  const float theta = degrees(std::acos(std::clamp(cosine, -1.F, 1.F)));
  if (!(theta >= 0)) return table_.front();  // a direction without length: no angle to speak of
  const auto last = table_.size() - 1;
  return table_[std::min(static_cast<std::size_t>(std::lround(theta / step_)), last)];
}

Directivity::Directivity(const GeneralConfig& config) {
  for (const MicConfig& mic : config.mics) {
    mics_.emplace_back(vec3(mic.direction), mic.angle[0], mic.angle[1], config.n_thetas);
  }
  if (config.spatialfilters) {
    for (const SpatialFilterConfig& filter : *config.spatialfilters) {
      filters_.emplace_back(vec3(filter.direction), filter.angle[0], filter.angle[1], config.n_thetas);
    }
  } else if (const auto side = flat_array_side(config.mics)) {
    half_sphere_ = true;
    filters_.emplace_back(*side, 90.F, 90.F, config.n_thetas);
  }
}

float Directivity::filters(Vec3 direction) const noexcept {
  float gain = 1;
  for (const GainLaw& filter : filters_) gain *= filter(direction);
  return gain;
}

}  // namespace odas
