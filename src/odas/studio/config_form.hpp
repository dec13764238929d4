// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "odas/config/reader.hpp"

namespace odas {

/// A configuration as a form: for each section its fields with kind, unit, range, meaning, choices, default
/// and value, whether it is written and on which line; as docs/protocol.md has it. All of it follows from the
/// schemas, so that a new key is a new field of the form.
[[nodiscard]] nlohmann::json config_form(LoadedConfiguration loaded);

/// What of one setting of a section is written, and no more: `{"type":"file"}`. Null: nothing of it.
[[nodiscard]] nlohmann::json written_value(LoadedConfiguration& loaded, std::string_view section,
                                           std::string_view key);

}  // namespace odas
