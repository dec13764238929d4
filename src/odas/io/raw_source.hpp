// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/io/file_descriptor.hpp"
#include "odas/io/sample_format.hpp"

namespace odas {

/// Headerless PCM from a file, a pipe or a device file, as `raw` describes it.
class RawSource : public AudioSource {
 public:
  /// Throws IoError: missing, not readable, a folder, empty.
  RawSource(std::filesystem::path file, const RawConfig& raw);

  [[nodiscard]] std::size_t channels() const noexcept override { return channels_; }
  [[nodiscard]] int sample_rate() const noexcept override { return sample_rate_; }
  [[nodiscard]] bool live() const noexcept override { return false; }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override { return total_; }
  [[nodiscard]] ReadResult read(GridView<float> block) override;
  [[nodiscard]] std::string warning() const override;

 private:
  std::filesystem::path file_;
  std::size_t channels_;
  int sample_rate_;
  SampleFormat format_;
  FileDescriptor descriptor_;
  bool regular_ = true;  // else: reading may wait for somebody
  std::optional<std::uint64_t> total_;
  std::vector<char> bytes_;
  std::size_t held_ = 0;  // bytes of an unfinished block
  bool ended_ = false;
};

}  // namespace odas
