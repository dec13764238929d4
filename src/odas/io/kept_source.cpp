// SPDX-License-Identifier: MIT
#include "odas/io/kept_source.hpp"

#include <algorithm>
#include <utility>

#include "odas/engine/signals_blocked.hpp"
#include "odas/io/file_writer.hpp"
#include "odas/io/pcm.hpp"
#include "odas/io/sample_format.hpp"
#include "odas/io/wav_writer.hpp"

namespace odas {
namespace {

// Some two seconds of hops of 8 ms: a disk may look away for as long.
constexpr std::size_t kQueueLength = 256;
constexpr auto kFlushPeriod = std::chrono::milliseconds(900);
constexpr auto kRemindAfter = std::chrono::seconds(10);

/// Bits that hold all that the source can say.
int kept_bits(const RawConfig& raw) { return raw.format == "auto" ? 32 : bits_of(stream_format(raw)); }

}  // namespace

KeptSource::KeptSource(std::unique_ptr<AudioSource> source, const RawConfig& raw,
                       std::unique_ptr<ByteWriter> writer, bool unsigned_bytes)
    : source_(std::move(source)),
      writer_(std::move(writer)),
      bits_(kept_bits(raw)),
      unsigned_bytes_(unsigned_bytes),
      queue_(kQueueLength, {Grid<float>(source_->channels(), static_cast<std::size_t>(raw.hop_size))}),
      zeros_(source_->channels(), static_cast<std::size_t>(raw.hop_size)) {
  const SignalsBlocked signals_blocked;
  thread_ = std::thread([this] { write_all(); });
}

KeptSource::~KeptSource() { static_cast<void>(KeptSource::finish()); }

ReadResult KeptSource::read(GridView<float> block) {
  ReadResult result = source_->read(block);
  silence_ += result.lost;
  if (result.frames > 0) {
    Block* kept = source_->live() ? queue_.begin_push() : &queue_.wait_push();
    if (kept == nullptr) {
      silence_ += result.frames;
      unkept_ += result.frames;
      if (Clock::now() - said_ > kRemindAfter) {
        said_ = Clock::now();
        result.notice += (result.notice.empty() ? "" : "; ") + ("raw.record: " + writer_->where()) +
                         " is too slow: " + std::to_string(unkept_) + " frames are silence in it so far";
      }
    } else {
      ODAS_EXPECT(result.frames <= kept->samples.cols());
      for (std::size_t c = 0; c < block.rows(); ++c) {
        std::copy_n(block[c].data(), result.frames, kept->samples[c].data());
      }
      kept->frames = result.frames;
      kept->silence = std::exchange(silence_, 0);
      queue_.end_push();
    }
  }
  if (failed_.load(std::memory_order_relaxed) && result.status.ok()) {
    result.end = true;
    const std::scoped_lock lock(fault_mutex_);
    result.status = IoStatus::failed("raw.record: " + fault_);
  }
  return result;
}

IoStatus KeptSource::finish() {
  if (!std::exchange(finished_, true)) {
    Block& last = queue_.wait_push();
    last.end = true;
    last.frames = 0;
    last.silence = std::exchange(silence_, 0);
    queue_.end_push();
    thread_.join();
  }
  const std::scoped_lock lock(fault_mutex_);
  return fault_.empty() ? IoStatus() : IoStatus::failed("raw.record: " + fault_);
}

/// The writer's thread. After a failure it only empties the queue, so that nobody waits for it.
void KeptSource::write_all() noexcept {
  Clock::time_point flushed = Clock::now();
  for (bool end = false; !end;) {
    const Block& block = queue_.wait_front();
    try {
      if (!failed_.load(std::memory_order_relaxed)) fail(write(block));
      if (Clock::now() - flushed > kFlushPeriod) {
        flushed = Clock::now();
        if (!failed_.load(std::memory_order_relaxed)) fail(writer_->flush());
      }
    } catch (const std::exception& error) { fail(IoStatus::failed(error.what())); }
    end = block.end;
    queue_.pop();
  }
  fail(writer_->close());
}

IoStatus KeptSource::write(const Block& block) {
  for (std::uint64_t left = block.silence; left > 0;) {
    const auto n = static_cast<std::size_t>(std::min<std::uint64_t>(left, zeros_.cols()));
    IoStatus status = write_samples(GridView<const float>(zeros_.data(), zeros_.rows(), n, zeros_.cols()));
    if (!status.ok()) return status;
    left -= n;
  }
  const Grid<float>& s = block.samples;
  return block.frames == 0 ? IoStatus()
                           : write_samples(GridView<const float>(s.data(), s.rows(), block.frames, s.cols()));
}

IoStatus KeptSource::write_samples(GridView<const float> samples) {
  bytes_.resize(samples.rows() * samples.cols() * pcm_bytes(bits_));
  static_cast<void>(encode_pcm(samples, 1, bits_, bytes_));
  if (unsigned_bytes_) {
    for (char& byte : bytes_) byte = static_cast<char>(byte ^ '\x80');
  }
  return writer_->write(bytes_);
}

void KeptSource::fail(const IoStatus& status) {
  if (status.ok()) return;
  const std::scoped_lock lock(fault_mutex_);
  if (fault_.empty()) fault_ = status.what();
  failed_.store(true, std::memory_order_relaxed);
}

std::unique_ptr<AudioSource> keep_source(std::unique_ptr<AudioSource> source, const RawConfig& raw) {
  const InterfaceConfig& to = raw.record.interface;
  if (to.type == "blackhole") return source;
  const bool wav = to.path.ends_with(".wav");
  const int bits = kept_bits(raw);
  std::unique_ptr<ByteWriter> writer;
  if (wav) {
    writer = std::make_unique<WavWriter>(to.path,
                                         WavWriter::Format{source->sample_rate(), source->channels(), bits});
  } else {
    writer = std::make_unique<FileWriter>(to.path);
  }
  return std::make_unique<KeptSource>(std::move(source), raw, std::move(writer), wav && bits == 8);
}

}  // namespace odas
