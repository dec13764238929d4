// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "odas/base/field.hpp"
#include "odas/engine/config.hpp"

namespace odas {

/// The value of one field of `object` as JSON: groups are objects, lists arrays of them. Null for a field
/// that is known and ignored.
[[nodiscard]] nlohmann::json value_of(const Field& field, void* object);

/// A whole configuration by its keys: `{"raw":{"fS":16000,...},...}`.
[[nodiscard]] nlohmann::json values_of(Configuration config);

}  // namespace odas
