// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// What separation needs to hear a voice from before its track was found: the spectra of L hops ago, and
/// where the tracks of now were then.
///
/// Method: a track that lives now is heard as if it had lived L hops ago: where it was then, if it did live
///   then in this slot, else where it was first. A slot that is empty now gives nothing, and so a voice ends
///   L hops before its track does: nothing is lost, as long as a track outlives its talker by L hops.
/// Shapes: spectra [mic][bin], tracks [slot]. Memory: L + 1 spectra. L = 0: the hop itself.
class LookBack {
 public:
  LookBack(std::size_t hops, std::size_t mics, std::size_t bins, std::size_t slots);

  /// Where the spectra of the hop that begins are to be written.
  GridView<cfloat> begin_hop() noexcept;
  /// Takes the tracks of this hop, and gives those same with the directions of L hops ago.
  [[nodiscard]] std::span<const Track> recall(std::span<const Track> tracks) noexcept;
  /// The spectra of L hops ago: silence in the first L hops.
  [[nodiscard]] GridView<const cfloat> spectra() const noexcept;

  void reset() noexcept;

  [[nodiscard]] std::size_t hops() const noexcept { return spectra_.size() - 1; }
  [[nodiscard]] std::size_t memory_bytes() const noexcept;

 private:
  struct Place {
    std::uint64_t id = 0;
    Vec3 direction;
  };
  [[nodiscard]] std::size_t oldest() const noexcept { return (newest_ + 1) % spectra_.size(); }

  std::size_t newest_ = 0;             // in the rings
  std::vector<Grid<cfloat>> spectra_;  // [hop] of [mic][bin]
  Grid<Place> places_;                 // [hop][slot]
  std::vector<Place> first_;           // [slot]: where its track was first
  std::vector<Track> tracks_;          // [slot]: of now, as they were
};

}  // namespace odas
