// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "odas/engine/audio_source.hpp"

namespace odas {

/// A recording as fast as it was made: block n is given when its last frame would have been heard, counted
/// from the first read, so that no error adds up. It remains a recording: if what listens is too slow, it
/// waits, and then catches up.
class PacedSource : public AudioSource {
 public:
  using Clock = std::chrono::steady_clock;
  /// Tells the time, and lets it pass. For tests; a steady clock otherwise.
  struct Time {
    std::function<Clock::time_point()> now;
    std::function<void(Clock::duration)> sleep;
  };

  explicit PacedSource(std::unique_ptr<AudioSource> recording);
  PacedSource(std::unique_ptr<AudioSource> recording, Time time);

  [[nodiscard]] std::size_t channels() const noexcept override { return recording_->channels(); }
  [[nodiscard]] int sample_rate() const noexcept override { return recording_->sample_rate(); }
  [[nodiscard]] bool live() const noexcept override { return false; }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override {
    return recording_->total_frames();
  }
  [[nodiscard]] ReadResult read(GridView<float> block) override;
  [[nodiscard]] std::string warning() const override { return recording_->warning(); }

 private:
  std::unique_ptr<AudioSource> recording_;
  Time time_;
  std::optional<Clock::time_point> start_;
  std::uint64_t given_ = 0;  // frames
};

}  // namespace odas
