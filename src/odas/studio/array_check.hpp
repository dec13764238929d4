// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "odas/config/reader.hpp"

namespace odas {

/// What the geometry of an array lets it hear, as the command `array.check` of docs/protocol.md says it: what
/// `odas array` prints and draws. With errors in the configuration, `faults` alone.
[[nodiscard]] nlohmann::json check_array(LoadedConfiguration loaded);

}  // namespace odas
