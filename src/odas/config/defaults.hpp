// SPDX-License-Identifier: MIT
#pragma once

#include "odas/config/locations.hpp"
#include "odas/engine/config.hpp"

namespace odas {

/// Gives each key that the user left out, and whose field says so, the value of another key (Field::derived):
/// an output has the rate of the processing unless it is told another.
void set_derived_defaults(Configuration& config, const Locations& locations);

}  // namespace odas
