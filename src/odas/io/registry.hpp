// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/sink.hpp"

namespace odas {

/// The source that `raw.interface` asks for. Throws ConfigError where its kind is not there yet, IoError
/// where it cannot be opened.
[[nodiscard]] std::unique_ptr<AudioSource> make_source(const RawConfig& raw);

struct SinkOptions {
  /// Nobody waits for those who read: the source is live. From a recording everybody gets everything, unless
  /// he sleeps.
  bool live = false;
  /// Set when the run is to end: nobody then waits for a listener.
  const std::atomic<bool>* stop = nullptr;
  /// Told, in the thread of the sinks, which peers come, go and fall behind. May be empty.
  std::function<void(const std::string&)> say{};
  /// When the first hop is, for the formats that carry the time of day.
  std::chrono::system_clock::time_point start = std::chrono::system_clock::now();
};

/// The sinks that a configuration asks for; a blackhole is none. Throws ConfigError with all formats and
/// kinds that a stream cannot be, IoError where one cannot be opened: before anything has started.
[[nodiscard]] std::vector<std::unique_ptr<Sink>> make_sinks(const Configuration& config,
                                                            const SinkOptions& options = {});

}  // namespace odas
