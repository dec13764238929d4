// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace odas {

/// How many letters must be put in, taken out, changed or swapped with the next one to get from `a` to `b`
/// (Damerau 1964, optimal string alignment); upper and lower case are alike.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word that was probably meant; empty where none is near (a third of its letters, at least one).
[[nodiscard]] std::string_view nearest(std::string_view word, std::span<const std::string_view> words);

}  // namespace odas
