// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/array/types.hpp"

namespace odas {

/// How long ago somebody walked: for so long what is learned of the sound has been true.
///
/// Method: the direction of each track, averaged over half a second and over two. Somebody walks while these
///   are further apart than 0.12 of the array's radius, as its microphones see it: max |p_m . (a - b)| >
///   0.12 max |p_m|, which is 7 degrees along an array and more where it sees little, as a flat one the
///   elevation. A walker of 7 degrees a second is seen; an estimate that wavers is not.
/// Symbols: p_m: position of microphone m, from their centre; a, b: the averages.
/// Shapes: tracks[slot]. Units: s. Cost: slots x microphones x 3 products a hop. Delay: up to two seconds.
/// Errors: a direction that is not finite is passed over.
/// Fails: who walks slower than the two averages can tell stands still.
class Stillness {
 public:
  Stillness(const GeneralConfig& general, std::size_t slots);

  /// Takes the tracks of one hop.
  void update(std::span<const Track> tracks) noexcept;
  /// Since somebody walked; without end where nobody did.
  [[nodiscard]] float seconds() const noexcept { return seconds_; }
  void reset() noexcept;

 private:
  struct Place {
    std::uint64_t id = 0;  // 0: nobody
    Vec3 now, before;      // a, b
  };

  [[nodiscard]] bool walks(const Place& place) const noexcept;

  float hop_seconds_;
  float far_;                    // m
  std::vector<Vec3> positions_;  // [mic]: p
  std::vector<Place> places_;    // [slot]
  float seconds_;
};

}  // namespace odas
