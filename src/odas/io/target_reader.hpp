// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "odas/io/json_cutter.hpp"
#include "odas/tracking/target.hpp"

namespace odas {

/// The fixed directions that one message asks for, or why it cannot be taken; then those before it hold.
struct TargetMessage {
  bool replaces = true;              // `targets` are all that there are; else they come to those before
  TargetList targets;                // a tag that is there already moves to its new direction
  std::vector<std::string> removed;  // tags that go, before `targets` come
  std::size_t surplus = 0;           // targets beyond what a TargetList holds: left out
  std::string fault;                 // "" if the message is good; one line

  [[nodiscard]] bool is_good() const noexcept { return fault.empty(); }
};

/// Reads one message, the whole of `json`. All targets: `{"targets":[{"tag":"a","x":1,"y":0,"z":0}]}`, as in
/// ODAS's phoenix; or a change: `{"add":[{"tag":"a",...}],"remove":["b"]}`, of which either may be absent.
/// Other keys are passed over, and so are targets with an empty tag. Faults: no JSON of this form, a tag over
/// 63 bytes, "dynamic" or given twice, a direction that is no direction.
[[nodiscard]] TargetMessage read_targets(std::string_view json);

/// The targets once a good message has been heeded. `surplus`: how many there was no room for.
[[nodiscard]] TargetList heed(const TargetMessage& message, const TargetList& before, std::size_t& surplus);

/// Messages one after another, with or without space between them, that arrive in pieces of any size. What is
/// no message is one with a fault, and reading goes on (JsonCutter).
class TargetReader {
 public:
  static constexpr std::size_t kLongest = JsonCutter::kLongest;  // bytes of a message

  /// A piece of what arrives. Ask `next` until it has no more before the next piece.
  void push(std::string_view piece) { cutter_.push(piece); }
  /// The next whole message, good or not; none: more bytes are needed.
  [[nodiscard]] std::optional<TargetMessage> next();
  /// Forgets what has arrived: another peer is speaking.
  void reset() { cutter_.reset(); }

 private:
  JsonCutter cutter_;
};

}  // namespace odas
