// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/engine/config.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// What a configuration comes to, for a reader: the array, what the rates and sizes mean in ms and Hz, the
/// search, the delay of the whole chain, the memory, and what goes where. Ends with a line break.
[[nodiscard]] std::string describe_plan(const Configuration& config, const Pipeline::Plan& plan);

}  // namespace odas
