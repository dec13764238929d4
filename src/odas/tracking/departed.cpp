// SPDX-License-Identifier: MIT
#include "odas/tracking/departed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odas {
namespace {

constexpr std::size_t kCapacity = 64;

}  // namespace

std::uint64_t hops_in(double seconds, double hop_seconds) noexcept {
  constexpr double kForEver = 1e18;
  return hop_seconds > 0 ? static_cast<std::uint64_t>(std::min(std::ceil(seconds / hop_seconds), kForEver))
                         : 0;
}

Departed::Departed(std::uint64_t hops) : hops_(hops), sources_(hops > 0 ? kCapacity : 0) {}

void Departed::add(std::uint64_t id, Vec3 direction, std::size_t slot) noexcept {
  if (sources_.empty()) return;
  // A free place before any other, and the oldest before a younger one.
  const auto place = std::min_element(sources_.begin(), sources_.end(), [](const Source& a, const Source& b) {
    return a.id == 0 || b.id == 0 ? a.id == 0 && b.id != 0 : a.since < b.since;
  });
  *place = {id, direction, slot, now_};
}

void Departed::age() noexcept {
  ++now_;
  for (Source& source : sources_) {
    if (source.id != 0 && now_ - source.since > hops_) source = {};
  }
}

void Departed::reset() noexcept {
  now_ = 0;
  std::fill(sources_.begin(), sources_.end(), Source{});
}

std::optional<Departed::Match> Departed::nearest(Vec3 direction) const noexcept {
  std::optional<Match> best;
  float least = std::cos(radians(kNear));
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const float cosine = dot(sources_[i].direction, direction);
    if (sources_[i].id == 0 || cosine < least) continue;
    best = Match{i, cosine};
    least = cosine;
  }
  return best;
}

Departed::Source Departed::take(std::size_t place) noexcept {
  return std::exchange(sources_[place], Source{});
}

}  // namespace odas
