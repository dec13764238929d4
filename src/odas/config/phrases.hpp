// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "odas/base/field.hpp"

namespace odas {

/// The shortest text that reads back as the number: 16000, 0.1, 1e-20.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(float value);

[[nodiscard]] std::string in_quotes(std::string_view word);

/// "0 to 1", "more than 0", "at least 2"; empty where all is allowed.
[[nodiscard]] std::string range_text(const Range& range);

/// "a", "b" or "c"
[[nodiscard]] std::string choices_text(std::span<const std::string_view> choices);

}  // namespace odas
