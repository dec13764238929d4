// SPDX-License-Identifier: MIT
// What is true of a scene, and what a system said of it: the two sides of a score.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace odas {

/// A direction in double precision: an error of a thousandth of a degree is not lost in its cosine. Need not
/// be of length 1: systems print few decimals.
struct Direction {
  double x = 0, y = 0, z = 0;
};

/// How far two directions are apart, in degrees.
enum class Measure {
  angle,   // between the two vectors
  azimuth  // around the z axis alone: for flat arrays, which hardly hear elevation
};
[[nodiscard]] double distance_deg(Measure measure, const Direction& a, const Direction& b) noexcept;

/// A source by hops.
struct KnownSource {
  std::vector<Direction> direction;  // [hop]
  std::vector<std::uint8_t> active;  // [hop]: it speaks
};

struct KnownScene {
  int sample_rate = 16000;
  std::size_t hop_size = 128;  // samples
  std::size_t hops = 0;
  std::vector<KnownSource> sources;  // each with `hops` entries

  [[nodiscard]] double hop_seconds() const noexcept {
    return static_cast<double>(hop_size) / static_cast<double>(sample_rate);
  }
  [[nodiscard]] double minutes() const noexcept { return static_cast<double>(hops) * hop_seconds() / 60; }
};

/// A followed source in one hop.
struct HeardTrack {
  std::size_t slot = 0;
  std::uint64_t id = 0;  // 0: none
  Direction direction;
};

/// The tracks of one hop. A hop that is not said has none.
struct HeardHop {
  std::size_t hop = 0;  // from 0
  std::vector<HeardTrack> tracks;
};

/// The strongest potential of one hop.
struct HeardPotential {
  std::size_t hop = 0;  // from 0
  Direction direction;
};

}  // namespace odas
