// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "odas/scene/scene.hpp"

namespace odas {

/// Amplitude of a noise at a frequency, up to a factor: white 1; pink falls by 3 dB an octave over 50 Hz;
/// fan: as air and motor sound, 6 dB an octave over 150 Hz, and little under it; motor: the harmonics of a
/// shaft's 110 Hz up to some kHz, over a floor; babble: as white, for its colour comes from its voices.
[[nodiscard]] float noise_amplitude(NoiseColour colour, float hertz) noexcept;

/// Noise of one point, of RMS 1.
[[nodiscard]] std::vector<float> point_noise(NoiseColour colour, std::size_t samples, int sample_rate,
                                             std::uint32_t seed);

/// Spherically isotropic noise, as in the open or deep in a reverberant hall. RMS about 1 for a microphone
/// that hears all around.
///
/// Method: plane waves from kWaves directions evenly on the sphere (Fibonacci's spiral), independent of each
/// other; each shifts in phase exactly by its way between the microphones. The coherence of two
/// omnidirectional microphones tends to sinc(2 f d / c) (Cook et al., JASA 27(6), 1955). Babble: a crowd of
/// kCrowd talkers, each one of `scene.noise->voices` from another moment on, that comes from kWaves / kCrowd
/// directions up to 50 ms apart, as from the walls of a hall. Shapes: [mic][sample].
[[nodiscard]] Grid<float> diffuse_noise(const Scene& scene, NoiseColour colour, std::uint32_t seed);

}  // namespace odas
