// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "odas/base/spsc_queue.hpp"
#include "odas/engine/audio_source.hpp"
#include "odas/engine/config.hpp"
#include "odas/io/byte_writer.hpp"

namespace odas {

/// A source of which a copy is kept while it is read: all channels, as they come, before any mapping, with
/// silence for what was lost (`raw.record`). A thread of its own writes it: a live source never waits for the
/// disk. What the disk is too slow for is silence in the copy, and counted.
class KeptSource : public AudioSource {
 public:
  /// Takes what `writer` writes to; WAVs have unsigned bytes at 8 bits.
  KeptSource(std::unique_ptr<AudioSource> source, const RawConfig& raw, std::unique_ptr<ByteWriter> writer,
             bool unsigned_bytes);
  ~KeptSource() override;

  [[nodiscard]] std::size_t channels() const noexcept override { return source_->channels(); }
  [[nodiscard]] int sample_rate() const noexcept override { return source_->sample_rate(); }
  [[nodiscard]] bool live() const noexcept override { return source_->live(); }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override {
    return source_->total_frames();
  }
  [[nodiscard]] ReadResult read(GridView<float> block) override;
  [[nodiscard]] std::string warning() const override { return source_->warning(); }
  IoStatus finish() override;

  /// Frames that the disk was too slow for.
  [[nodiscard]] std::uint64_t unkept_frames() const noexcept { return unkept_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Block {
    Grid<float> samples;  // [channel][raw hop]
    std::size_t frames = 0;
    std::uint64_t silence = 0;  // frames before these
    bool end = false;
  };
  void write_all() noexcept;
  IoStatus write(const Block& block);
  IoStatus write_samples(GridView<const float> samples);
  void fail(const IoStatus& status);

  std::unique_ptr<AudioSource> source_;
  std::unique_ptr<ByteWriter> writer_;
  int bits_;
  bool unsigned_bytes_;
  SpscQueue<Block> queue_;
  std::uint64_t silence_ = 0;  // frames that the next block has to make up for
  std::uint64_t unkept_ = 0;
  Clock::time_point said_{};
  bool finished_ = false;

  // The writer's.
  std::vector<char> bytes_;
  Grid<float> zeros_;
  std::atomic<bool> failed_{false};
  std::mutex fault_mutex_;
  std::string fault_;
  std::thread thread_;
};

/// `source` itself, or with its copy, as `raw.record` says. Throws IoError where that cannot be written.
[[nodiscard]] std::unique_ptr<AudioSource> keep_source(std::unique_ptr<AudioSource> source,
                                                       const RawConfig& raw);

}  // namespace odas
