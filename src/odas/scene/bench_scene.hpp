// SPDX-License-Identifier: MIT
// The scenes of the benchmarks: each is drawn from a few conditions and a seed, and made when it is played.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/scene/scene.hpp"

namespace odas {

enum class BenchNoise { none, diffuse, fan, babble, ego };
enum class BenchMotion { still, walking, crossing, pausing };

[[nodiscard]] const char* name_of(BenchNoise noise) noexcept;
[[nodiscard]] const char* name_of(BenchMotion motion) noexcept;

/// The conditions of a scene; all else is drawn by its seed.
struct BenchScene {
  std::string group;      // what it is for: "mixed", "crossing", ...
  int number = 0;         // in its group and half
  bool test = false;      // of the half to report on; else of the one to tune on
  std::string array;      // name of its configuration
  int mics = 0;           // of the array
  float rt60 = 0;         // s
  float distance = 1.5F;  // m
  BenchNoise noise = BenchNoise::none;
  float snr_db = 30;
  int talkers = 1;
  BenchMotion motion = BenchMotion::still;
  bool inexact = false;  // microphones 2 mm beside where they should be, amplifiers 3 dB apart
  double seconds = 8;
  std::uint32_t seed = 1;

  /// "mixed/test/17"
  [[nodiscard]] std::string name() const;
  /// Name and conditions: "mixed/test/17 ps3_eye mics=4 rt60=0.4 ..."; two scenes with the same text are the
  /// same.
  [[nodiscard]] std::string text() const;
};

/// Draws the scene and lets its talkers speak. `array`: of the configuration; the microphones of an inexact
/// scene are elsewhere, and the listener does not know. Throws IoError: no espeak-ng.
///
/// Room: 5 to 9 m long, larger where the talkers are far, the array about in its middle at a height of 0.9 to
/// 1.3 m. Talkers: at 0.85 to 1.15 of the distance, at least 35 degrees apart, where the array searches: up
/// to 40 degrees high, a line in front of it and level. `walking` goes round by 60 to 100 degrees; `crossing`
/// changes places with the next; `pausing` is silent for 1.5 s or more between sentences. Voices differ
/// between the halves, as do the words. Noise: `diffuse` is pink; `fan` comes from a point 1 to 2.5 m away,
/// over quiet diffuse noise; `babble` is a crowd all around; `ego` is a fan and two motors 0.2 to 0.35 m from
/// the array, at its height or lower. Without any there is diffuse noise at 30 dB.
[[nodiscard]] Scene make_scene(const BenchScene& bench, const GeneralConfig& array);

}  // namespace odas
