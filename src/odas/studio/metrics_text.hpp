// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace odas {

/// The figures of a `health` message, and of a `beams` message beside them, as Prometheus reads them. Those
/// that are absent or null are left out. Of beams, the label is the slot: ids are never used again, and would
/// pile up.
[[nodiscard]] std::string metrics_text(const nlohmann::json& health);

}  // namespace odas
