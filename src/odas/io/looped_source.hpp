// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "odas/engine/audio_source.hpp"

namespace odas {

/// A recording that begins anew whenever it ends, without a gap: one run that goes on for ever.
class LoopedSource : public AudioSource {
 public:
  using Open = std::function<std::unique_ptr<AudioSource>()>;
  /// `open` gives the recording from its beginning, each time with the same channels and rate. Throws what it
  /// throws.
  explicit LoopedSource(Open open) : open_(std::move(open)), recording_(open_()) {}

  [[nodiscard]] std::size_t channels() const noexcept override { return recording_->channels(); }
  [[nodiscard]] int sample_rate() const noexcept override { return recording_->sample_rate(); }
  [[nodiscard]] bool live() const noexcept override { return false; }
  [[nodiscard]] ReadResult read(GridView<float> block) override;
  [[nodiscard]] std::string warning() const override { return recording_->warning(); }

 private:
  Open open_;
  std::unique_ptr<AudioSource> recording_;
};

}  // namespace odas
