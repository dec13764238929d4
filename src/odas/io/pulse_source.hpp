// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/io/frame_clock.hpp"

namespace odas {

/// A source of PulseAudio, or of PipeWire, which speaks the same protocol.
///
/// Channels are taken as they are numbered; with `channelmap` by their names, as ODAS asks for them. Neither
/// mixes them. A server or a source that goes away is waited for, and the frames of the meantime are lost, as
/// are those that the server says it had to leave out.
class PulseSource : public AudioSource {
 public:
  /// Throws IoError where there is no such source, ConfigError where it does not have the channels of `raw`.
  explicit PulseSource(const RawConfig& raw);
  ~PulseSource() override;

  [[nodiscard]] std::size_t channels() const noexcept override { return channels_; }
  [[nodiscard]] int sample_rate() const noexcept override { return raw_.fs; }
  [[nodiscard]] bool live() const noexcept override { return true; }
  [[nodiscard]] ReadResult read(GridView<float> block) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Connection;
  struct Refusal {
    std::string why;      // "": it runs
    bool misfit = false;  // it is there, and cannot do what `raw` says
  };
  [[nodiscard]] Refusal connect(Clock::time_point deadline, bool first);
  void reconnect(ReadResult& result);
  void lose(const std::string& why, ReadResult& result);
  void take(GridView<float> block, ReadResult& result);

  RawConfig raw_;
  std::size_t channels_;
  std::unique_ptr<Connection> connection_;  // none while it is away
  Clock::time_point heard_{};
  FrameClock away_;
  Clock::time_point next_try_{};
  Clock::duration pause_{};
  std::string notice_;  // to be told with the next block
};

}  // namespace odas
