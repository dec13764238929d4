// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "odas/io/sample_format.hpp"

namespace odas {

/// Tells a WAV from headerless samples by the first bytes of a stream, and reads its header, however the
/// bytes are cut. Nothing is sought: pipes and sockets cannot.
/// Source: Microsoft, "Multimedia programming interface and data specifications 1.0"; EBU Tech 3306 (RF64).
class WavHeader {
 public:
  enum class State : std::uint8_t {
    undecided,   // more bytes are needed
    headerless,  // what has been taken, and all that follows, are samples
    samples,     // a WAV: all that follows are samples, as `format` says
    broken,      // `fault` says why
  };
  struct Format {
    SampleFormat samples = SampleFormat::s16;
    std::size_t channels = 0;
    int sample_rate = 0;
    std::uint64_t bytes = kEndless;  // of samples; kEndless: to the end of the stream
  };
  static constexpr std::uint64_t kEndless = std::numeric_limits<std::uint64_t>::max();

  /// Takes bytes until it has decided; says how many.
  std::size_t push(std::span<const char> bytes);

  [[nodiscard]] State state() const noexcept { return state_; }
  [[nodiscard]] const Format& format() const noexcept { return format_; }
  [[nodiscard]] const std::string& fault() const noexcept { return fault_; }
  /// What was taken before it was known to be headerless: the first samples.
  [[nodiscard]] std::span<const char> taken() const noexcept {
    return {held_.data(), part_ == Part::magic ? size_ : 0};
  }
  /// So many bytes may be taken before it is known that there is no header.
  static constexpr std::size_t kMagic = 12;  // RIFF, size, WAVE

 private:
  enum class Part : std::uint8_t { magic, chunk_head, chunk_body };

  void take(char byte);
  void begin_chunk();
  void end_chunk();
  void read_format();
  void fail(std::string why);
  [[nodiscard]] std::uint64_t number(std::size_t at, std::size_t bytes) const noexcept;

  State state_ = State::undecided;
  Part part_ = Part::magic;
  std::array<char, 64> held_{};  // the beginning of this part: no more of any chunk is looked at
  std::size_t size_ = 0;
  std::array<char, 4> tag_{};    // of this chunk
  std::uint64_t left_ = 0;       // bytes of it, with its padding
  std::uint64_t long_size_ = 0;  // of the samples, as ds64 says
  bool known_ = false;           // the format has been read
  Format format_;
  std::string fault_;
};

}  // namespace odas
