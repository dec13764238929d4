// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/io/frame_clock.hpp"
#include "odas/io/pcm_assembler.hpp"
#include "odas/io/stream_port.hpp"

namespace odas {

/// Samples from a socket or from standard input.
///
/// TCP and pipes hold a sender back who is faster than we are: nothing is lost while a stream runs, and what
/// is sent from a file is taken as fast as it can be processed. A peer that closes after it has sent samples
/// ends the input, as in ODAS, unless `reconnect` is set; one that is absent, or is lost by an error, is
/// waited for. The time in which a peer is away counts as lost.
class StreamSource : public AudioSource {
 public:
  StreamSource(const RawConfig& raw, std::unique_ptr<StreamPort> port);

  [[nodiscard]] std::size_t channels() const noexcept override { return channels_; }
  [[nodiscard]] int sample_rate() const noexcept override { return sample_rate_; }
  [[nodiscard]] bool live() const noexcept override { return false; }
  [[nodiscard]] ReadResult read(GridView<float> block) override;
  [[nodiscard]] std::string warning() const override { return warning_; }

 private:
  using Clock = std::chrono::steady_clock;
  void wait_for_stream(ReadResult& result, Clock::time_point deadline);
  void take(ReadResult& result, Clock::time_point deadline, std::size_t wanted);
  void stream_over(ReadResult& result, int error);

  std::size_t channels_;
  int sample_rate_;
  bool reconnect_;
  std::unique_ptr<StreamPort> port_;
  FileDescriptor stream_;
  PcmAssembler assembler_;
  std::vector<char> bytes_;
  std::size_t held_ = 0, at_ = 0;  // bytes_[at_ .. held_] wait for room
  std::uint64_t received_ = 0;     // bytes of this stream
  FrameClock away_;
  bool ended_ = false;
  IoStatus fault_;
  std::string warning_;
};

}  // namespace odas
