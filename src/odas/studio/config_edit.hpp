// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "odas/studio/document.hpp"

namespace odas {

/// A value as a configuration writes it: `{"a":[1,0.5]}` -> `{ a = (1, 0.5); }`. Keys with null are left out.
/// Throws ConfigError where no configuration can hold it.
[[nodiscard]] std::string setting_text(const nlohmann::json& value);

/// The document's text with another source: `source` has keys of `raw.interface`, and `fS`, `nChannels`,
/// `nBits`, `hopSize` and `format` of `raw`.
[[nodiscard]] std::string with_source(const Document& document, const nlohmann::json& source);

/// The text after changes, `[{"path":"sst.N_prob","value":5}]`, one after another: null takes a key, or an
/// item of a list, out; an item at one past the last puts it in. Everything else stays as it was, comments
/// too, but for comments within a group or list that a change reaches into. Throws ConfigError: no such key,
/// or a value that no configuration can hold.
[[nodiscard]] std::string with_changes(std::string text, const std::string& name,
                                       const nlohmann::json& changes);

}  // namespace odas
