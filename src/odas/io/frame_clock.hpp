// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace odas {

/// How many frames the time has brought since it was started: what is lost while a device or a peer is away.
/// By a clock that no one sets, so that a jump of the time of day does no harm.
class FrameClock {
 public:
  using Clock = std::chrono::steady_clock;

  explicit FrameClock(int sample_rate) : sample_rate_(sample_rate) {}

  void start(Clock::time_point now) {
    running_ = true;
    begin_ = now;
    given_ = 0;
  }
  void stop() { running_ = false; }
  [[nodiscard]] bool running() const noexcept { return running_; }

  /// Frames since the start that have not been given yet. 0 while it does not run.
  [[nodiscard]] std::uint64_t take(Clock::time_point now) {
    if (!running_ || now < begin_) return 0;
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    const auto all = static_cast<std::uint64_t>(seconds * sample_rate_);
    const std::uint64_t fresh = all > given_ ? all - given_ : 0;
    given_ += fresh;
    return fresh;
  }

 private:
  int sample_rate_;
  bool running_ = false;
  Clock::time_point begin_;
  std::uint64_t given_ = 0;
};

}  // namespace odas
