// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "odas/io/wav_header.hpp"

namespace odas {

/// Bytes of a stream, in chunks of any size, to frames of samples. Where a stream begins with the header of a
/// WAV, the header says how its samples are; it must have the channels and the rate that are expected.
///
/// Memory is bounded by its capacity, whatever comes. Any bytes are samples: floats may be no numbers.
class PcmAssembler {
 public:
  struct Expected {
    SampleFormat samples = SampleFormat::s16;  // without a header
    std::size_t channels = 1;
    int sample_rate = 16000;
  };
  /// `capacity`: frames that may wait, about.
  PcmAssembler(Expected expected, std::size_t capacity);

  /// Takes as many bytes as there is room for, and says how many.
  std::size_t push(std::span<const char> bytes);
  [[nodiscard]] std::size_t capacity() const noexcept { return ready_.cols() - WavHeader::kMagic; }
  /// Whole frames that wait.
  [[nodiscard]] std::size_t frames() const noexcept { return end_ - begin_; }
  /// Fills `block` [channel][frame] with as many as wait and fit; says how many.
  std::size_t pop(GridView<float> block) noexcept;

  /// No more of this stream is samples: a WAV has ended. All further bytes are taken and ignored.
  [[nodiscard]] bool over() const noexcept { return over_; }
  /// Why this stream cannot be read: it "has 2 channels, but ..."; "" if it can.
  [[nodiscard]] const std::string& fault() const noexcept { return fault_; }

  /// The stream has ended; another may begin. Whole frames are kept. Gives how many bytes of a torn frame
  /// were thrown away.
  std::size_t finish();

 private:
  void accept_header();
  std::size_t push_samples(std::span<const char> bytes);
  void make_room();

  Expected expected_;
  SampleFormat format_;  // of this stream
  WavHeader header_;
  std::uint64_t left_ = WavHeader::kEndless;  // bytes of samples of this stream
  bool over_ = false;
  std::string fault_;
  std::vector<char> torn_;  // the beginning of a frame
  Grid<float> ready_;       // [channel][capacity]: frames begin_ .. end_ wait
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace odas
