// SPDX-License-Identifier: MIT
#pragma once

namespace odas {

/// Prints file, line and the broken condition, and aborts.
[[noreturn]] void contract_broken(const char* condition, const char* file, int line) noexcept;

}  // namespace odas

/// A precondition of ours. Checked in debug, test and sanitizer builds; costs nothing in release builds.
#if defined(NDEBUG) && !defined(ODAS_CHECK_CONTRACTS)
// Not computed, but seen: what only a contract reads is not unused.
#define ODAS_EXPECT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#else
#define ODAS_EXPECT(condition) \
  ((condition) ? static_cast<void>(0) : ::odas::contract_broken(#condition, __FILE__, __LINE__))
#endif
