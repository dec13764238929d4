// SPDX-License-Identifier: MIT
#include "odas/localization/peak_fit.hpp"

#include <algorithm>
#include <cmath>

#include "odas/array/geometry.hpp"

namespace odas {

TangentPlane::TangentPlane(Vec3 u) noexcept {
  const float across = std::hypot(u.x, u.y);
  east = across > 1e-6F ? Vec3{-u.y / across, u.x / across, 0} : Vec3{0, 1, 0};
  north = odas::cross(u, east);
}

PeakFit::PeakFit(const GeneralConfig& general, const SearchPlan& plan, int interp_rate)
    : half_lags_(static_cast<float>(plan.half_lags)) {
  const float scale = static_cast<float>(general.samplerate.mu * interp_rate) / general.speedofsound.mu;
  for (const auto& [i, j] : plan.pairs) {
    baselines_.push_back(-scale * (position(general.mics[i]) - position(general.mics[j])));
  }
  if (plan.summary.half_sphere) side_ = flat_array_side(general.mics);
}

PeakFit::Derivatives PeakFit::at(GridView<const float> correlations, std::span<const std::uint8_t> heard,
                                 Vec3 u) const noexcept {
  const TangentPlane plane(u);
  Derivatives d;
  float pairs = 0;
  for (std::size_t q = 0; q < baselines_.size(); ++q) {
    if (heard[q] == 0) continue;
    const float l = lag(q, u);
    const float column = std::clamp(l + half_lags_, 1.F, 2 * half_lags_ - 1);
    const float nearest = std::round(column);
    const float* x = correlations.data() + q * correlations.stride() + static_cast<std::size_t>(nearest);
    const float t = column - nearest;
    const float first = 0.5F * (x[1] - x[-1]);
    const float second = x[1] - 2 * x[0] + x[-1];
    const float slope = first + t * second;
    const float l_east = dot(baselines_[q], plane.east);
    const float l_north = dot(baselines_[q], plane.north);
    d.energy += x[0] + t * (first + 0.5F * t * second);
    d.slope_east += slope * l_east;
    d.slope_north += slope * l_north;
    d.east += second * l_east * l_east - slope * l;
    d.north += second * l_north * l_north - slope * l;
    d.cross += second * l_east * l_north;
    pairs += 1;
  }
  const float scale = pairs > 0 ? 1 / pairs : 0;
  for (float* value : {&d.energy, &d.slope_east, &d.slope_north, &d.east, &d.north, &d.cross})
    *value *= scale;
  return d;
}

Vec3 PeakFit::onto_side(Vec3 u) const noexcept {
  if (!side_) return u;
  const float depth = dot(u, *side_);
  return depth < 0 ? normalized(u - depth * *side_) : u;
}

PeakFit::Fit PeakFit::fit(GridView<const float> correlations, std::span<const std::uint8_t> heard,
                          Vec3 start) const noexcept {
  constexpr int kSteps = 6;
  constexpr float kLongest = 0.07F;  // rad, of a step
  constexpr float kShortest = 0.002F;
  Vec3 u = onto_side(start);
  Derivatives here = at(correlations, heard, u);
  for (int step = 0; step < kSteps; ++step) {
    // Where the response is not concave, a step of full length uphill.
    const float det = here.east * here.north - here.cross * here.cross;
    const bool concave = here.east < 0 && det > 0;
    float east = here.slope_east;
    float north = here.slope_north;
    if (concave) {
      east = (here.cross * here.slope_north - here.north * here.slope_east) / det;
      north = (here.cross * here.slope_east - here.east * here.slope_north) / det;
    }
    const float length = std::hypot(east, north);
    if (!(length > 0)) break;
    float scale = concave ? std::min(1.F, kLongest / length) : kLongest / length;
    const TangentPlane plane(u);
    bool higher = false;
    for (int halving = 0; halving < 4 && !higher; ++halving, scale *= 0.5F) {
      const Vec3 there = onto_side(normalized(u + scale * (east * plane.east + north * plane.north)));
      const Derivatives next = at(correlations, heard, there);
      if (next.energy > here.energy) {
        u = there;
        here = next;
        higher = true;
      }
    }
    if (!higher || scale * length < kShortest) break;
  }
  return {u, here.energy, -here.east, -here.north, -here.cross};
}

}  // namespace odas
