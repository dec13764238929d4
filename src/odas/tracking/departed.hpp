// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "odas/base/vec3.hpp"

namespace odas {

/// How many hops such a time takes; none where hops have no length.
[[nodiscard]] std::uint64_t hops_in(double seconds, double hop_seconds) noexcept;

/// Sources whose tracks have ended, for as long as they may come back and be known again.
class Departed {
 public:
  /// How far from its last direction a source may come back. About twice the deviation of an observation
  /// (sigmaR2_active of ODAS's files: 8.6 degrees), and less than what keeps two people apart.
  static constexpr float kNear = 15;  // degrees

  /// Remembers each for so many hops; none if 0. At most 64 of them, the latest.
  explicit Departed(std::uint64_t hops);

  void add(std::uint64_t id, Vec3 direction, std::size_t slot) noexcept;
  /// A hop has passed.
  void age() noexcept;
  void reset() noexcept;

  struct Match {
    std::size_t place;
    float cosine;  // of the angle between the two
  };
  /// The nearest one that is near enough.
  [[nodiscard]] std::optional<Match> nearest(Vec3 direction) const noexcept;
  struct Source {
    std::uint64_t id = 0;  // 0: a free place
    Vec3 direction{};
    std::size_t slot = 0;  // that it had
    std::uint64_t since = 0;
  };
  /// It is not among the departed any more.
  Source take(std::size_t place) noexcept;

 private:
  std::uint64_t hops_;
  std::uint64_t now_ = 0;
  std::vector<Source> sources_;
};

}  // namespace odas
