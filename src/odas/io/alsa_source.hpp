// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "odas/engine/audio_source.hpp"
#include "odas/io/alsa_pcm.hpp"
#include "odas/io/frame_clock.hpp"

namespace odas {

/// A sound card, or any other PCM of ALSA.
///
/// An overrun is recovered from; a card that is pulled out, or gives no sound any more, is opened again and
/// again until it is back. The frames of the meantime, from the last one that was read, count as lost: by the
/// steady clock, for the card has none while it is away.
class AlsaSource : public AudioSource {
 public:
  using Clock = std::chrono::steady_clock;
  /// All that a test plays in its stead.
  struct World {
    AlsaOpener open = open_alsa;
    std::function<std::string(int error)> error_text = alsa_error;
    std::function<std::string(const std::string& pcm)> owner;
    std::function<Clock::time_point()> now;
    std::function<void(Clock::duration)> sleep;
    World();
  };

  /// `pcm`: its name in ALSA. Throws IoError where it cannot be opened, ConfigError where it cannot do what
  /// `raw` says.
  AlsaSource(std::string pcm, const RawConfig& raw, World world = {});

  [[nodiscard]] std::size_t channels() const noexcept override { return channels_; }
  [[nodiscard]] int sample_rate() const noexcept override { return raw_.fs; }
  [[nodiscard]] bool live() const noexcept override { return true; }
  [[nodiscard]] ReadResult read(GridView<float> block) override;

  [[nodiscard]] SampleFormat format() const noexcept { return format_; }
  [[nodiscard]] std::uint64_t overruns() const noexcept { return overruns_; }

 private:
  struct Refusal {
    std::string why;      // "": it runs
    bool misfit = false;  // it is there, and cannot do what `raw` says
  };
  [[nodiscard]] Refusal open();
  void reopen(ReadResult& result);
  void recover(int error, ReadResult& result);
  void give_up(const std::string& why, ReadResult& result);
  void note_position(Clock::time_point now);

  std::string name_;
  RawConfig raw_;
  World world_;
  std::size_t channels_;
  SampleFormat format_ = SampleFormat::s16;
  std::unique_ptr<AlsaPcm> pcm_;  // none while it is away
  std::vector<char> bytes_;
  Clock::time_point heard_{};  // when the frame after the last one that was read was captured
  Clock::time_point alive_{};  // when it last gave anything
  FrameClock away_;
  Clock::time_point next_try_{};
  Clock::duration pause_{};
  std::uint64_t overruns_ = 0;
  std::uint64_t lost_ = 0;  // frames, by overruns
  bool overrun_ = false;    // and not yet running again
  Clock::time_point said_{};
};

}  // namespace odas
