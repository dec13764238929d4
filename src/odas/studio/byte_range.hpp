// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace odas {

/// Bytes `first` to `last`, both included.
struct ByteRange {
  std::uint64_t first = 0, last = 0;
  [[nodiscard]] std::uint64_t size() const noexcept { return last - first + 1; }
};

enum class RangeKind { whole, part, unsatisfiable };

/// What the header `Range` asks of a file of `size` bytes. Several ranges, and what is no range, ask for the
/// whole, as RFC 9110 allows.
[[nodiscard]] RangeKind read_range(std::string_view header, std::uint64_t size, ByteRange& range);

}  // namespace odas
