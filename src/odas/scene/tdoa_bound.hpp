// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "odas/scene/listening.hpp"

namespace odas {

/// How exactly a scene's sound lets anybody measure the TDoA of each talker between two microphones, at best.
///
/// Method: var(tdoa) >= 1 / (2 T int (2 pi f)^2 C / (1 - C) df), C = (S / (S + N))^2, the squared coherence
/// of two microphones in noise of their own (Cramer and Rao). S: the talker's direct sound while he speaks;
/// N: all else but the other talkers, that is noise and his own echoes, which are taken for diffuse. From 100
/// Hz to 7 kHz, T = kBoundSeconds. With DoaError it gives the bound of the direction for the array's
/// aperture. Symbols: f in Hz. Source: Knapp and Carter, IEEE Trans. ASSP 24(4), 1976, eq. 39. Fails: echoes
/// and diffuse noise are alike in microphones that are close, so that at low frequencies the bound is a
/// little too good; who averages over longer than T may come below it. Shapes: [target], s.
inline constexpr double kBoundSeconds = 0.25;
[[nodiscard]] std::vector<double> tdoa_bounds(const Scene& scene, const PlayedScene& played);

}  // namespace odas
