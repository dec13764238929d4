// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace odas {

/// Messages to all clients who have subscribed to their topic. Any thread; never waits.
class Announcer {
 public:
  virtual ~Announcer() = default;
  /// `message` has a `type`; `topic` as in `subscribe`; "": everybody.
  virtual void announce(const std::string& topic, const nlohmann::json& message) = 0;
};

}  // namespace odas
