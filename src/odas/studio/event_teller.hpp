// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "odas/studio/hop_listener.hpp"

namespace odas {

/// Tells when sources appear, disappear and change their class, as the message `event` of docs/protocol.md.
///
/// A class is told once it has held for kHeld, for it is heard anew in each hop and wavers at the edges of
/// words.
class EventTeller : public HopListener {
 public:
  static constexpr double kHeld = 0.5;  // s
  using Tell = std::function<void(const nlohmann::json& event)>;

  explicit EventTeller(Tell tell) : tell_(std::move(tell)) {}

  void begin(const StreamInfo& info) override;
  void hop(const HopResult& hop) override;
  /// Everybody disappears.
  void end() override;

 private:
  struct Known {
    Track track;
    Category told = Category::undefined;
    Category heard = Category::undefined;
    HopIndex since = 0;  // when `heard` began
    HopIndex seen = 0;
  };
  void tell(const char* what, const Known& source, HopIndex time) const;

  Tell tell_;
  std::optional<StreamInfo> info_;
  HopIndex last_ = 0;
  std::map<std::uint64_t, Known> known_;  // by id
};

}  // namespace odas
