// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "odas/io/json_cutter.hpp"
#include "odas/io/stream_record.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas {

/// Takes what one connection brings, in pieces of any size.
class StreamIntake {
 public:
  virtual ~StreamIntake() = default;

  /// A failure is one of writing; nonsense is said, and passed over.
  virtual IoStatus take(std::span<const char> bytes) = 0;
  /// What was written so far is valid where it lies.
  virtual IoStatus flush() { return {}; }
  /// The sender has gone: what is there is finished.
  virtual IoStatus close() = 0;
  /// "1502 hops, 3 missing", "12.3 s".
  [[nodiscard]] virtual std::string amount() const = 0;
  /// "separated.wav", once something has come that belongs into a file of this connection alone.
  [[nodiscard]] virtual std::string file() const { return ""; }
};

using Say = std::function<void(const std::string&)>;

/// Objects of JSON. The first nonsense of a connection is said with its first bytes, the rest is counted.
class TextIntake : public StreamIntake {
 public:
  using Receive = std::function<IoStatus(const StreamRecord&, std::string_view text)>;

  TextIntake(StreamKind expected, Receive receive, Say say)
      : expected_(expected), receive_(std::move(receive)), say_(std::move(say)) {}

  IoStatus take(std::span<const char> bytes) override;
  IoStatus close() override { return {}; }
  [[nodiscard]] std::string amount() const override;

 private:
  void refuse(std::string_view text, const std::string& fault);
  void count(const StreamRecord& record);

  StreamKind expected_;
  Receive receive_;
  Say say_;
  JsonCutter cutter_;
  std::array<HopIndex, 3> last_{};  // of each kind; 0: none yet
  std::uint64_t hops_ = 0, missing_ = 0, refused_ = 0;
};

/// Interleaved samples, into a WAV file: signed, little-endian, as ODAS sends them. Text is passed over.
class AudioIntake : public StreamIntake {
 public:
  /// Called when the first sample is there. May throw IoError.
  using Open = std::function<std::unique_ptr<WavWriter>(const WavWriter::Format&)>;

  AudioIntake(const WavWriter::Format& format, Open open, Say say);

  IoStatus take(std::span<const char> bytes) override;
  IoStatus flush() override { return file_ ? file_->flush() : IoStatus(); }
  IoStatus close() override;
  [[nodiscard]] std::string amount() const override;
  [[nodiscard]] std::string file() const override;

 private:
  WavWriter::Format format_;
  Open open_;
  Say say_;
  std::unique_ptr<WavWriter> file_;
  std::size_t frame_size_;     // bytes
  std::vector<char> pending_;  // of a frame that is not whole yet
  std::uint64_t frames_ = 0;
  bool begun_ = false;
  bool is_text_ = false;
};

/// What a person can read of bytes that may be anything: `GET / HTTP/1.1\x0d\x0a`.
[[nodiscard]] std::string excerpt(std::string_view bytes);

}  // namespace odas
