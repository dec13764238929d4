// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// A direction that is always followed, known by its tag.
struct Target {
  ShortString<63> tag{};
  Vec3 direction{0, 0, 1};  // any length but zero

  friend bool operator==(const Target&, const Target&) = default;
};

struct SstConfig;
/// The fixed directions that a configuration begins with: `sst.target`.
[[nodiscard]] std::vector<Target> targets_of(const SstConfig& config);

/// Why a target cannot be followed; "" if it can.
[[nodiscard]] const char* fault_of(const Target& target) noexcept;

/// Targets in place: copied without allocation, so it can be handed from thread to thread through a queue.
class TargetList {
 public:
  static constexpr std::size_t kCapacity = 64;

  /// Leaves out what cannot be followed: a target with a fault, the tag of one before it, or beyond the
  /// capacity. Returns how many those were.
  std::size_t assign(std::span<const Target> targets) noexcept;

  [[nodiscard]] std::span<const Target> view() const noexcept { return {items_.data(), size_}; }
  [[nodiscard]] const Target* find(const ShortString<63>& tag) const noexcept;

 private:
  std::array<Target, kCapacity> items_{};
  std::size_t size_ = 0;
};

}  // namespace odas
