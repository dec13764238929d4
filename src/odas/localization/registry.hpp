// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "odas/array/config.hpp"
#include "odas/localization/config.hpp"
#include "odas/localization/localizer.hpp"

namespace odas {

/// The localizer that `ssl.mode` names. Throws ConfigError for a name that is not in the table.
[[nodiscard]] std::unique_ptr<Localizer> make_localizer(const GeneralConfig& general, const SslConfig& ssl);

}  // namespace odas
