// SPDX-License-Identifier: MIT
#include "odas/studio/subscription.hpp"

#include <algorithm>

#include "odas/studio/rpc.hpp"

namespace odas {

using nlohmann::json;

double Subscription::rate_of(const std::string& topic) const {
  const auto found = topics.find(topic);
  return found == topics.end() ? 0 : std::clamp(found->second, 0.0, kMostPerSecond);
}

void Subscription::add_to(HopRing::Demand& demand) const {
  if (rate_of("hops") > 0) (potentials ? demand.hops : demand.bare) = true;
  if (rate_of("meters") > 0) demand.meters = true;
  if (rate_of("power") > 0) demand.power = true;
  for (const Audio& one : audio) demand.audio[static_cast<std::size_t>(one.stream)] = true;
}

Subscription read_subscription(const json& message) {
  Subscription subscription;
  try {
    const json topics = message.value("topics", json::object());
    if (!topics.is_object()) throw RpcError("bad_request", "subscribe: topics is an object");
    for (const auto& [topic, rate] : topics.items()) { subscription.topics[topic] = rate.get<double>(); }
    subscription.potentials = message.value("potentials", true);
    for (const json& one : message.value("audio", json::array())) {
      const std::string name = one.at("stream");
      std::size_t stream = 0;
      while (stream < kAudioStreams && name != name_of(static_cast<AudioStream>(stream))) ++stream;
      if (stream == kAudioStreams) throw RpcError("bad_request", "there is no audio stream '" + name + "'");
      const bool raw = static_cast<AudioStream>(stream) == AudioStream::raw;
      subscription.audio.push_back(
          {static_cast<AudioStream>(stream), one.at(raw ? "mic" : "track").get<std::uint32_t>()});
      if (subscription.audio.size() > Subscription::kMostAudio) {
        throw RpcError("bad_request", "a client can hear " + std::to_string(Subscription::kMostAudio) +
                                          " voices at once at most");
      }
    }
  } catch (const json::exception& error) {
    throw RpcError("bad_request", std::string("subscribe: ") + error.what());
  }
  return subscription;
}

}  // namespace odas
