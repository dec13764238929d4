// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "odas/engine/audio_source.hpp"

namespace odas {

/// WAV, FLAC and all else that libsndfile knows by its header.
class SoundFileSource : public AudioSource {
 public:
  /// Throws IoError: missing, not readable, no sound file, empty.
  explicit SoundFileSource(std::filesystem::path file);

  [[nodiscard]] std::size_t channels() const noexcept override { return channels_; }
  [[nodiscard]] int sample_rate() const noexcept override { return sample_rate_; }
  [[nodiscard]] bool live() const noexcept override { return false; }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override { return total_; }
  [[nodiscard]] ReadResult read(GridView<float> block) override;
  [[nodiscard]] std::string warning() const override;

 private:
  /// " after 1.2 s of 2.0 s"
  [[nodiscard]] std::string share(std::uint64_t of) const;

  struct Closer {
    void operator()(void* sound) const noexcept;
  };

  std::filesystem::path file_;
  std::unique_ptr<void, Closer> sound_;  // SNDFILE*
  std::size_t channels_ = 0;
  int sample_rate_ = 0;
  std::optional<std::uint64_t> total_;
  std::uint64_t promised_ = 0;   // frames that the header speaks of
  std::uint64_t delivered_ = 0;  // frames
  bool ended_ = false;
  std::vector<float> interleaved_;
};

}  // namespace odas
