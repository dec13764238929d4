// SPDX-License-Identifier: MIT
// The types in which the rooms of the pipeline speak to each other.
#pragma once

#include <complex>
#include <cstdint>

#include "odas/base/grid.hpp"
#include "odas/base/short_string.hpp"
#include "odas/base/vec3.hpp"

namespace odas {

using cfloat = std::complex<float>;

/// Hops since the start, from 1. What ODAS's JSON calls timeStamp. seconds = (time - 1) * hop / rate.
using HopIndex = std::uint64_t;

/// How uncertain a direction is, in its tangent plane, rad^2. East is where azimuth grows, north where
/// elevation does. All zero: not told.
struct TangentCovariance {
  float east = 0;
  float north = 0;
  float cross = 0;  // of east and north
};

/// A direction that may hold a source in this hop. `energy` is E in ODAS's scale: about 1 for one coherent
/// plane wave, 0.05 to 0.1 for noise; it does not depend on the level. `evidence` and `covariance` are told
/// by the localizers that know them.
struct Potential {
  Vec3 direction{0, 0, 1};
  float energy = 0;
  float evidence = 0;  // ln p(what was heard | a source is there) / p(... | none is)
  TangentCovariance covariance{};
};

/// What a followed source is. `undefined`: an empty slot, or nobody asked.
enum class Category : std::uint8_t { undefined, nonspeech, speech };

/// A source that is followed. The index in the list of tracks is its slot, and so its audio channel.
struct Track {
  std::uint64_t id = 0;  // 0: an empty slot. Ids rise and are never used again
  ShortString<63> tag{};
  Vec3 direction{};
  float activity = 0;                       // 0..1: how sure it is that the source sounds in this hop
  Category category = Category::undefined;  // written by the classifier, where it runs
  TangentCovariance covariance{};           // of the direction, where the tracker knows it
};

}  // namespace odas
