// SPDX-License-Identifier: MIT
// What the room simulator is told, and what it gives. No file and no JSON here: see scene_file.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "odas/base/grid.hpp"
#include "odas/base/vec3.hpp"

namespace odas {

/// A microphone with a first-order pattern: gain = omni + (1 - omni) cos(angle from its axis).
struct SceneMic {
  Vec3 position;       // m, from the middle of the array
  Vec3 axis{0, 0, 1};  // unit; where it points
  float omni = 1;      // 1: omnidirectional, 0.5: cardioid, 0: figure of eight
  float gain = 1;      // of its amplifier
};

/// Where a source is at a time, seen from the middle of the array.
struct Waypoint {
  double time = 0;      // s
  float azimuth = 0;    // degrees
  float elevation = 0;  // degrees
  float distance = 1;   // m
};

struct SceneSource {
  std::string name;
  std::vector<float> sound;    // at the rate of the scene, from its beginning; shorter is padded by silence
  std::vector<Waypoint> path;  // not empty, times rising; straight in azimuth, elevation, distance between
  bool is_target = true;       // false: directional noise, which is not in the truth
  bool is_played = false;      // by the machine itself: SimulatedScene::played knows it
};

enum class NoiseColour { white, pink, fan, motor, babble };

/// Noise from everywhere alike.
struct DiffuseNoise {
  NoiseColour colour = NoiseColour::white;
  float snr_db = 20;  // of the targets while at least one speaks, to the noise; mean over the microphones
  std::vector<std::vector<float>> voices;  // babble: those of whom the crowd is made, at the scene's rate
};

struct Scene {
  int sample_rate = 16000;
  double seconds = 10;
  std::size_t hop = 128;  // samples; the truth has an entry a hop
  float speed_of_sound = 343;
  Vec3 room{6, 5, 3};                  // m
  float rt60 = 0;                      // s; 0: free field, no walls
  Vec3 array_position{3, 2.5F, 1.2F};  // of the middle of the array, from a corner of the room
  std::vector<SceneMic> mics;
  std::vector<SceneSource> sources;
  std::optional<DiffuseNoise> noise;
  std::optional<float>
      directional_snr_db;      // as snr_db, to all sources that are no targets; none: as loud as they are
  float noise_level_db = -50;  // dB of full scale of the noise where no target says how loud it has to be
  std::uint32_t seed = 1;

  [[nodiscard]] std::size_t samples() const noexcept {
    return static_cast<std::size_t>(seconds * sample_rate);
  }
  [[nodiscard]] std::size_t hops() const noexcept {
    return static_cast<std::size_t>(seconds / (static_cast<double>(hop) / sample_rate));
  }
};

/// Where a source is, and whether it sounds, as it is heard in the middle of the array at the middle of a
/// hop.
struct SourceTruth {
  std::string name;
  std::vector<Vec3> direction;       // [hop], unit
  std::vector<std::uint8_t> active;  // [hop]
};

struct SimulatedScene {
  Grid<float> mics;                        // [mic][sample]
  std::vector<std::vector<float>> images;  // [target][sample]: it alone, as the first microphone hears it
  std::vector<Grid<float>> images_at_all;  // [target][mic][sample]; only where it was asked for
  std::vector<SourceTruth> truth;          // [target]
  std::vector<float> played;               // [sample]: what the machine plays; empty where nothing is
  float scale = 1;                         // what all was multiplied by, so that nothing clips
};

}  // namespace odas
