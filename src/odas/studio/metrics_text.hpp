// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace odas {

/// The figures of a `health` message as Prometheus reads them. Those that are absent or null are left out.
[[nodiscard]] std::string metrics_text(const nlohmann::json& health);

}  // namespace odas
