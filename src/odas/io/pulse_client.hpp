// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odas/io/capture_offer.hpp"

struct pa_context;
struct pa_operation;

namespace odas {

/// A source of PulseAudio.
struct PulseDevice {
  std::string name, description;
  CaptureOffer offer;    // its own format, rate and channels: into anything else the server converts
  bool monitor = false;  // what a loudspeaker plays, and no microphone
};

/// A connection to a server of PulseAudio, or of PipeWire, which speaks the same protocol. It has no thread
/// of its own: `run` is where things happen.
class PulseClient {
 public:
  using Clock = std::chrono::steady_clock;

  PulseClient();
  ~PulseClient();
  PulseClient(const PulseClient&) = delete;
  PulseClient& operator=(const PulseClient&) = delete;

  /// Why there is no server, or no answer in time; "" if there is one. `spawn`: start one where a user has
  /// none.
  [[nodiscard]] std::string connect(Clock::time_point deadline, bool spawn);
  [[nodiscard]] bool good() const;
  [[nodiscard]] std::string error() const;
  [[nodiscard]] pa_context* context() const noexcept { return context_; }

  /// Lets things happen for at most so long.
  void run(Clock::duration at_most);

  /// The source of this name; nothing where there is none, or no answer in time.
  [[nodiscard]] std::optional<PulseDevice> source(const std::string& name, Clock::time_point deadline);
  [[nodiscard]] std::vector<PulseDevice> sources(Clock::time_point deadline);

 private:
  /// Waits for it and lets go of it. Whether it was done in time.
  bool finish(pa_operation* operation, Clock::time_point deadline);

  struct Loop;
  std::unique_ptr<Loop> loop_;
  pa_context* context_ = nullptr;
};

}  // namespace odas
