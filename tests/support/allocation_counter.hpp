// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace odas::test {

/// Calls of operator new in the whole program so far. A program that asks gets a counting operator new.
[[nodiscard]] std::size_t allocations() noexcept;

}  // namespace odas::test
