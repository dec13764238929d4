// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "odas/engine/io_status.hpp"

namespace odas {

/// Where the bytes of a sink go. A record (a hop of JSON, a block of samples) is written whole or not at all.
class ByteWriter {
 public:
  virtual ~ByteWriter() = default;

  /// For messages: "tracks.json".
  [[nodiscard]] virtual std::string where() const = 0;

  virtual IoStatus write(std::span<const char> record) = 0;
  /// What was written must now be where a reader sees it.
  virtual IoStatus flush() = 0;
  /// Finishes. Nothing is written after it, nor after a failure.
  virtual IoStatus close() = 0;
  /// Records that were given up, for want of a reader or because of a slow one.
  [[nodiscard]] virtual std::uint64_t lost_records() const noexcept { return 0; }
};

}  // namespace odas
