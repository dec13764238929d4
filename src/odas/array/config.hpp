// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "odas/base/field.hpp"

namespace odas {

/// One microphone: `general.mics[i]`.
struct MicConfig {
  std::array<float, 3> mu{};                // position, m, right-handed frame
  std::array<float, 9> sigma2{};            // 3x3 covariance of the position, m^2, row by row
  std::array<float, 3> direction{0, 0, 1};  // where it points; not zero, need not be unit
  std::array<float, 2> angle{180, 180};     // half-angles in degrees: full pass, no pass
  static Schema schema();
};

/// It passes everything from all around.
[[nodiscard]] inline bool is_omni(const MicConfig& mic) noexcept { return mic.angle[0] >= 180; }

/// A region of directions that is listened to: `general.spatialfilters[i]`. Several multiply.
struct SpatialFilterConfig {
  std::array<float, 3> direction{0, 0, 1};
  std::array<float, 2> angle{180, 180};
  static Schema schema();
};

struct SizeConfig {
  int hop_size = 128;
  int frame_size = 256;
  static Schema schema();
};

struct SampleRateConfig {
  int mu = 16000;
  static Schema schema();
};

struct SpeedOfSoundConfig {
  float mu = 343;
  float sigma2 = 25;
  static Schema schema();
};

/// The array and the sizes that all stages share: section `general`.
struct GeneralConfig {
  float epsilon = 1e-20F;
  SizeConfig size;
  SampleRateConfig samplerate;
  SpeedOfSoundConfig speedofsound;
  std::vector<MicConfig> mics;
  std::optional<std::vector<SpatialFilterConfig>> spatialfilters;  // absent: half sphere if the array is flat
  int n_thetas = 181;
  float gain_min = 0.25F;
  static Schema schema();
};

/// From one hop to the next, s.
[[nodiscard]] inline float hop_seconds_of(const GeneralConfig& general) noexcept {
  return static_cast<float>(general.size.hop_size) / static_cast<float>(general.samplerate.mu);
}

}  // namespace odas
