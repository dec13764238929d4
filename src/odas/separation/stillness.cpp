// SPDX-License-Identifier: MIT
#include "odas/separation/stillness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "odas/array/geometry.hpp"

namespace odas {
namespace {

// Of the two averages, s, and how far apart they are of one who walks, in radii of the array.
constexpr float kNowSeconds = 0.5F;
constexpr float kBeforeSeconds = 2;
constexpr float kFar = 0.12F;

}  // namespace

Stillness::Stillness(const GeneralConfig& general, std::size_t slots)
    : hop_seconds_(hop_seconds_of(general)), places_(slots) {
  Vec3 centre;
  for (const MicConfig& mic : general.mics) {
    positions_.push_back(position(mic));
    centre = centre + (1 / static_cast<float>(general.mics.size())) * positions_.back();
  }
  float radius = 0;
  for (Vec3& p : positions_) {
    p = p - centre;
    radius = std::max(radius, norm(p));
  }
  far_ = kFar * radius;
  reset();
}

void Stillness::update(std::span<const Track> tracks) noexcept {
  seconds_ += hop_seconds_;
  for (std::size_t s = 0; s < places_.size(); ++s) {
    Place& place = places_[s];
    const Vec3 direction = tracks[s].direction;
    if (!std::isfinite(norm(direction))) continue;
    if (place.id != tracks[s].id) place = {tracks[s].id, direction, direction};
    if (place.id == 0) continue;
    place.now = place.now + std::min(hop_seconds_ / kNowSeconds, 1.F) * (direction - place.now);
    place.before = place.before + std::min(hop_seconds_ / kBeforeSeconds, 1.F) * (direction - place.before);
    if (walks(place)) seconds_ = 0;
  }
}

bool Stillness::walks(const Place& place) const noexcept {
  const Vec3 way = place.now - place.before;
  return std::ranges::any_of(positions_, [&](Vec3 p) { return std::abs(dot(p, way)) > far_; });
}

void Stillness::reset() noexcept {
  seconds_ = std::numeric_limits<float>::infinity();
  std::ranges::fill(places_, Place{});
}

}  // namespace odas
