// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "odas/scene/truth.hpp"

namespace odas {

/// Writes what a system gave for a track in one hop, or silence where it gave nothing: [hop_size].
using VoiceOf = std::function<void(std::size_t hop, const HeardTrack& track, std::span<float> out)>;

/// What went into the microphones.
struct KnownSound {
  std::vector<float> mic;                  // the first microphone
  std::vector<std::vector<float>> images;  // [source]: it alone, as the first microphone hears it
};

/// Means over the sources that are followed for a second or more, dB. `_in`: the same of the first
/// microphone.
struct SeparationScore {
  double sdr = 0, sdr_in = 0;
  double si_sdr = 0, si_sdr_in = 0;
  std::optional<double> sir, sir_in;    // where several talk
  std::optional<double> stoi, stoi_in;  // where there is enough of it
};

/// Method: a source's voice is put together from its tracks (`followed`: [source][hop], id 0: none); where
/// none follows it, neither voice nor reference count. The voice is brought forward by the lag, up to half a
/// second, at which it is most like the reference. Empty where no source is followed for a second.
[[nodiscard]] std::optional<SeparationScore> score_separation(
    const KnownScene& scene, const KnownSound& sound, std::span<const std::vector<HeardTrack>> followed,
    const VoiceOf& voice_of);

}  // namespace odas
