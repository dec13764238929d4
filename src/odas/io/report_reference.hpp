// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "odas/engine/audio_source.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas {

/// A source that keeps one of its channels in a WAV file while it is read: what one microphone heard, beside
/// the voices.
class ReferenceTap final : public AudioSource {
 public:
  /// `channel` counts from 0. Throws IoError.
  ReferenceTap(AudioSource& source, std::size_t channel, const std::filesystem::path& file);

  [[nodiscard]] std::size_t channels() const noexcept override { return source_.channels(); }
  [[nodiscard]] int sample_rate() const noexcept override { return source_.sample_rate(); }
  [[nodiscard]] bool live() const noexcept override { return source_.live(); }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override {
    return source_.total_frames();
  }
  [[nodiscard]] ReadResult read(GridView<float> block) override;
  [[nodiscard]] std::string warning() const override { return source_.warning(); }

  /// Finishes the file.
  IoStatus close() { return wav_.close(); }

 private:
  AudioSource& source_;
  std::size_t channel_;
  WavWriter wav_;
  std::vector<float> finite_;
  std::vector<char> bytes_;
};

}  // namespace odas
