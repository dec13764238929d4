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

/// The text with the setting at `path` written otherwise, and all else as it was; null takes it out. Where an
/// item is changed of a list that has its default, that default is written out first. Throws ConfigError.
[[nodiscard]] std::string edited_text(const std::string& text, const std::string& path,
                                      const nlohmann::json& value);

/// The document's text with another source: `source` has keys of `raw.interface`, and `fS`, `nChannels`,
/// `nBits`, `hopSize` and `format` of `raw`.
[[nodiscard]] std::string with_source(const Document& document, const nlohmann::json& source);

}  // namespace odas
