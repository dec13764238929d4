// SPDX-License-Identifier: MIT
// What a server of the Studio says of itself to browsers, as its configuration wants it.
#pragma once

#include <string>
#include <vector>

#include "odas/engine/studio_config.hpp"

namespace odas {

/// The operators' token: that of the configuration, or, where others in the network listen, a new one.
[[nodiscard]] std::string operator_token(const StudioConfig& config);

/// Names, beside addresses, under which it may be asked for.
[[nodiscard]] std::vector<std::string> server_names(const StudioConfig& config);

/// Where a link leads to it: the address that it listens at, or, of all addresses, one that others find.
[[nodiscard]] std::string link_host(const StudioConfig& config);

/// The header Content-Security-Policy: all from the daemon itself, but pictures of the camera.
[[nodiscard]] std::string content_policy(const StudioConfig& config);

}  // namespace odas
