// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

/// How a noise of the machine sounds at the microphones, in each of its states: fans slow and fast, a motor
/// at work. Made by NoiseLearner, kept in a file (docs/noise.md), used by NoiseField.
struct NoiseDictionary {
  struct Entry {
    float share = 0;          // of the time that it was learned in
    float likeness = 0;       // mean and standard deviation of NoiseModel::likeness over the hops
    float deviation = 0;      //   that it was learned from
    std::vector<cfloat> scm;  // [bin][mic][mic]: E[x x^H] of unscaled, root-Hann windowed spectra
  };

  int sample_rate = 0;
  std::size_t hop_size = 0;
  std::size_t frame_size = 0;
  std::vector<Vec3> mics;  // m
  std::vector<Entry> entries;

  static constexpr std::size_t kMostEntries = 8;

  [[nodiscard]] bool empty() const noexcept { return entries.empty(); }
  [[nodiscard]] std::size_t bins() const noexcept { return frame_size / 2 + 1; }
  [[nodiscard]] std::span<const cfloat> scm(std::size_t entry, std::size_t bin) const noexcept {
    const std::size_t size = mics.size() * mics.size();
    return std::span(entries[entry].scm).subspan(bin * size, size);
  }
};

}  // namespace odas
