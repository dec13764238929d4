// SPDX-License-Identifier: MIT
#pragma once

namespace odas {

/// Keeps quotients of powers finite in silence, with samples of full scale 1.
inline constexpr float kTinyPower = 1e-30F;

}  // namespace odas
