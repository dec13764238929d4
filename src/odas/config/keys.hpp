// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace odas {

/// The reference of all keys, in Markdown, as docs/configuration.md holds it: key, default, what is allowed,
/// meaning. From the schema alone.
[[nodiscard]] std::string key_reference();

/// Where a key of this name stands: "ssl.nPots". Empty where no key has it, or several.
[[nodiscard]] std::string home_of_key(std::string_view key);

}  // namespace odas
