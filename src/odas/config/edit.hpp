// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace odas {

/// The text of a configuration with one setting of a group of the top level written otherwise, and all else,
/// comments too, as it was: `with_setting(text, "sst", "active", "( ... )")`. A setting that is absent is put
/// in at the group's beginning, a group that is absent at the end. `text` must be one that can be read.
[[nodiscard]] std::string with_setting(std::string_view text, std::string_view group, std::string_view name,
                                       std::string_view value);

/// The text without that setting, which may be absent.
[[nodiscard]] std::string without_setting(std::string_view text, std::string_view group,
                                          std::string_view name);

}  // namespace odas
