// SPDX-License-Identifier: MIT
#include "odas/pipeline/muting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odas {
namespace {

constexpr float kNone = -12;  // evidence: surely no source

}  // namespace

bool Muting::holds(Vec3 direction) const noexcept {
  static const float cosine = std::cos(kRadius * std::numbers::pi_v<float> / 180);
  const auto muted = directions_.view();
  return std::any_of(muted.begin(), muted.end(), [&](const Target& target) {
    return dot(normalized(target.direction), direction) >= cosine;
  });
}

void Muting::hush(std::span<Potential> potentials) const noexcept {
  for (Potential& potential : potentials) {
    if (!holds(potential.direction)) continue;
    potential.energy = 0;
    potential.evidence = kNone;
  }
}

void Muting::hush(std::span<Track> tracks) const noexcept {
  for (Track& track : tracks) {
    if (track.id != 0 && track.tag == "dynamic" && holds(track.direction)) track = {};
  }
}

}  // namespace odas
