// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>

namespace odas {

/// A WAV file of one channel, 16 bit, that is being written. Louder than full scale is clipped. The file is
/// valid once closed, also after a fault.
class MonoWav {
 public:
  /// Replaces the file. Throws IoError.
  MonoWav(std::filesystem::path file, int sample_rate);
  ~MonoWav();
  MonoWav(MonoWav&&) noexcept;
  MonoWav& operator=(MonoWav&&) noexcept;

  /// Throws IoError: the disk is full, ...
  void write(std::span<const float> samples);

  /// Finishes the file. Throws IoError.
  void close();

 private:
  struct Closer {
    void operator()(void* sound) const noexcept;
  };
  std::filesystem::path file_;
  std::unique_ptr<void, Closer> sound_;  // SNDFILE*
};

}  // namespace odas
