// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace odas::test {

/// How often this thread has asked for memory so far: malloc, calloc, realloc, aligned forms, operator new.
[[nodiscard]] std::uint64_t allocations() noexcept;

}  // namespace odas::test
