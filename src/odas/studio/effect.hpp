// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "odas/engine/config.hpp"

namespace odas {

/// What it takes to run by another configuration than now, from the gentlest on.
enum class Effect : std::uint8_t {
  none,     // the engine hears nothing of it
  live,     // the pipeline is replaced between two hops; time, ids and voices go on
  restart,  // the run begins anew at the same open source: no sound is lost
  reopen,   // the source is another one
};
[[nodiscard]] const char* name_of(Effect effect) noexcept;

/// `same_shapes`: a pipeline of `after` can take the place of one of `before` (Pipeline::can_continue).
[[nodiscard]] Effect effect_of(const Configuration& before, const Configuration& after, bool same_shapes);

}  // namespace odas
