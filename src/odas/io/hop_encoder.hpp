// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <span>

#include "odas/pipeline/pipeline.hpp"

namespace odas {

/// Turns a hop into the bytes of one record. The formats: docs/protocol.md.
class HopEncoder {
 public:
  virtual ~HopEncoder() = default;
  /// The parts of a hop that it reads.
  [[nodiscard]] virtual Wanted wanted() const noexcept = 0;
  /// The bytes hold until the next hop. Allocates nothing.
  [[nodiscard]] virtual std::span<const char> encode(const HopResult& hop) = 0;
};

/// ODAS's own JSON, byte for byte: all rows of all hops, empty slots too.
[[nodiscard]] std::unique_ptr<HopEncoder> make_odas_json_potentials();
[[nodiscard]] std::unique_ptr<HopEncoder> make_odas_json_tracks();
/// The classes of the tracks; an empty slot is "nonspeech", as it is in ODAS before its first track.
[[nodiscard]] std::unique_ptr<HopEncoder> make_odas_json_categories();

/// ODAS's binary potentials: x, y, z, E of each as 32-bit floats, little-endian; nothing else.
[[nodiscard]] std::unique_ptr<HopEncoder> make_binary_potentials();

/// When a hop was: `seconds` a hop, counted from `start`.
struct StreamClock {
  double hop_seconds = 0;
  std::chrono::system_clock::time_point start{};
};

/// JSON lines: one object a line, with angles and times; empty slots are left out.
[[nodiscard]] std::unique_ptr<HopEncoder> make_json_lines_potentials(const StreamClock& clock);
[[nodiscard]] std::unique_ptr<HopEncoder> make_json_lines_tracks(const StreamClock& clock);
[[nodiscard]] std::unique_ptr<HopEncoder> make_json_lines_categories(const StreamClock& clock);

}  // namespace odas
