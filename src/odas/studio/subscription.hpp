// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "odas/studio/hop_ring.hpp"

namespace odas {

/// What a client wants to get: his last `subscribe`.
struct Subscription {
  struct Audio {
    AudioStream stream = AudioStream::separated;
    std::uint32_t track = 0;  // of raw: the microphone, from 1
    friend bool operator==(const Audio&, const Audio&) = default;
  };
  static constexpr double kMostPerSecond = 60;
  static constexpr std::size_t kMostAudio = 16;

  std::map<std::string, double> topics;  // messages a second
  bool potentials = true;
  std::vector<Audio> audio;

  [[nodiscard]] double rate_of(const std::string& topic) const;
  /// Adds what it needs.
  void add_to(HopRing::Demand& demand) const;
};

/// Throws RpcError `bad_request`: a topic that is no number, audio of no such stream. Topics that nobody
/// knows are passed over.
[[nodiscard]] Subscription read_subscription(const nlohmann::json& message);

}  // namespace odas
