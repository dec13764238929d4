// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "odas/engine/audio_source.hpp"

namespace odas {

/// The beginning of another source.
class FirstSeconds : public AudioSource {
 public:
  FirstSeconds(AudioSource& source, double seconds)
      : source_(source), left_(static_cast<std::uint64_t>(std::lround(seconds * source.sample_rate()))) {
    total_ = source.total_frames() ? std::min(*source.total_frames(), left_) : left_;
  }

  [[nodiscard]] std::size_t channels() const noexcept override { return source_.channels(); }
  [[nodiscard]] int sample_rate() const noexcept override { return source_.sample_rate(); }
  [[nodiscard]] bool live() const noexcept override { return source_.live(); }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override { return total_; }
  [[nodiscard]] std::string warning() const override { return source_.warning(); }

  [[nodiscard]] ReadResult read(GridView<float> block) override {
    ReadResult result = source_.read(block);
    result.frames = static_cast<std::size_t>(std::min<std::uint64_t>(result.frames, left_));
    left_ -= result.frames;
    if (left_ == 0) result.end = true;
    return result;
  }

 private:
  AudioSource& source_;
  std::uint64_t left_;
  std::uint64_t total_ = 0;
};

}  // namespace odas
