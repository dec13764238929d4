// SPDX-License-Identifier: MIT
#include "odas/tracking/target.hpp"

#include <algorithm>
#include <cmath>

#include "odas/tracking/config.hpp"

namespace odas {

std::vector<Target> targets_of(const SstConfig& config) {
  std::vector<Target> targets;
  for (const TargetConfig& t : config.target) targets.push_back({std::string_view(t.tag), {t.x, t.y, t.z}});
  return targets;
}

const char* fault_of(const Target& target) noexcept {
  if (target.tag.empty()) return "has no tag";
  if (target.tag == "dynamic") return "has the tag of the sources that come and go";
  const float length = norm(target.direction);
  if (!(length > 0) || !std::isfinite(length)) return "points nowhere";
  return "";
}

std::size_t TargetList::assign(std::span<const Target> targets) noexcept {
  size_ = 0;
  for (const Target& target : targets) {
    if (size_ == kCapacity || *fault_of(target) != '\0' || find(target.tag) != nullptr) continue;
    items_[size_++] = {target.tag, normalized(target.direction)};
  }
  return targets.size() - size_;
}

const Target* TargetList::find(const ShortString<63>& tag) const noexcept {
  const auto here = view();
  const auto found =
      std::find_if(here.begin(), here.end(), [&](const Target& target) { return target.tag == tag; });
  return found == here.end() ? nullptr : &*found;
}

}  // namespace odas
