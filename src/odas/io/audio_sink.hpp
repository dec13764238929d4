// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "odas/dsp/resampler.hpp"
#include "odas/engine/config.hpp"
#include "odas/engine/sink.hpp"
#include "odas/io/byte_writer.hpp"

namespace odas {

/// A stream of voices: to its rate and block size, times its gain, as interleaved PCM with a channel for each
/// slot. A hop that was dropped is silence, so that the channels never slip.
class AudioSink : public Sink {
 public:
  enum class Stream { separated, postfiltered };

  struct Format {
    Stream stream = Stream::separated;
    std::size_t slots = 0;
    std::size_t hop = 0;          // of the pipeline
    int sample_rate = 16000;      // of the pipeline
    float gain = 1;               // sss.gain_sep or sss.gain_pf
    bool unsigned_bytes = false;  // 8 bits, as WAV has them
  };

  /// Throws ConfigError where the rates cannot be converted.
  AudioSink(const Format& format, const AudioOutputConfig& output, std::unique_ptr<ByteWriter> writer);

  [[nodiscard]] std::string name() const override;
  [[nodiscard]] Wanted wanted() const noexcept override;
  IoStatus write(const HopResult& hop) override;
  IoStatus flush() override { return writer_->flush(); }
  IoStatus close() override;
  [[nodiscard]] std::uint64_t clipped_samples() const noexcept override { return clipped_; }
  [[nodiscard]] std::uint64_t lost_records() const noexcept override { return writer_->lost_records(); }

 private:
  IoStatus push(GridView<const float> hop);
  IoStatus send(std::size_t frames);

  Format format_;
  int bits_;
  Resampler resampler_;
  Grid<float> block_;    // [slot][output block]
  Grid<float> silence_;  // [slot][hop]
  std::vector<char> bytes_;
  std::unique_ptr<ByteWriter> writer_;
  HopIndex expected_ = 1;
  std::uint64_t clipped_ = 0;
  bool well_ = true;
};

}  // namespace odas
