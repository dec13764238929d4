// SPDX-License-Identifier: MIT
// Sound devices of eight channels on a machine that has none.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "support/scratch.hpp"
#include <sys/types.h>

namespace odas::test {

inline constexpr std::size_t kVirtualChannels = 8;
inline constexpr std::size_t kVirtualFrame = 2 * kVirtualChannels;  // bytes
inline constexpr int kVirtualRate = 16000;

/// White noise of 16 bits, a quarter of full scale: in a sine a slip would go unseen.
[[nodiscard]] std::string noise_bytes(std::size_t frames, unsigned seed = 1);

/// A PCM of ALSA, "array8", that hears what is played to it, as fast as that is played: ALSA's `file` over
/// `null`, with a pipe for its file.
class VirtualCard {
 public:
  explicit VirtualCard(const Scratch& scratch);
  ~VirtualCard();
  VirtualCard(const VirtualCard&) = delete;
  VirtualCard& operator=(const VirtualCard&) = delete;

  /// Whether ALSA's configuration, which this one is added to, is there.
  [[nodiscard]] static bool possible();
  /// What the program that listens needs in its environment.
  [[nodiscard]] const std::string& environment() const noexcept { return environment_; }

  /// Plays in real time, and then silence until the end.
  void play(std::string bytes);
  [[nodiscard]] bool played() const noexcept { return played_; }

 private:
  std::string environment_;
  int pipe_ = -1;
  std::atomic<bool> stop_{false};
  std::atomic<bool> played_{false};
  std::thread player_;
};

/// A server of PulseAudio of our own, with a sink "mic8" of which the monitor is the array.
class VirtualPulse {
 public:
  explicit VirtualPulse(const Scratch& scratch);
  ~VirtualPulse() { end(); }
  VirtualPulse(const VirtualPulse&) = delete;
  VirtualPulse& operator=(const VirtualPulse&) = delete;

  [[nodiscard]] static bool possible();
  [[nodiscard]] bool ready() const;
  [[nodiscard]] const std::vector<std::string>& environment() const noexcept { return environment_; }

  void start();
  void end();
  /// Plays a headerless file with pacat, and waits for its end. Its exit code.
  [[nodiscard]] int play(const std::filesystem::path& file) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::string> environment_;
  pid_t server_ = -1;
};

}  // namespace odas::test
