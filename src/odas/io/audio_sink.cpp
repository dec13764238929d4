// SPDX-License-Identifier: MIT
#include "odas/io/audio_sink.hpp"

#include <utility>

#include "odas/io/pcm.hpp"

namespace odas {

AudioSink::AudioSink(const Format& format, const AudioOutputConfig& output,
                     std::unique_ptr<ByteWriter> writer)
    : format_(format),
      bits_(output.n_bits),
      resampler_(format.slots, format.sample_rate, output.fs, format.hop,
                 static_cast<std::size_t>(output.hop_size)),
      block_(format.slots, static_cast<std::size_t>(output.hop_size)),
      silence_(format.slots, format.hop),
      bytes_(format.slots * block_.cols() * pcm_bytes(output.n_bits)),
      writer_(std::move(writer)) {}

std::string AudioSink::name() const {
  const char* stream = format_.stream == Stream::separated ? "sss.separated" : "sss.postfiltered";
  return std::string(stream) + " (" + writer_->where() + ")";
}

Wanted AudioSink::wanted() const noexcept {
  const bool separated = format_.stream == Stream::separated;
  return {.potentials = false, .tracks = false, .separated = separated, .postfiltered = !separated};
}

IoStatus AudioSink::write(const HopResult& hop) {
  for (; expected_ < hop.time; ++expected_) {
    if (IoStatus status = push(silence_); !status.ok()) return status;
  }
  expected_ = hop.time + 1;
  return push(format_.stream == Stream::separated ? hop.separated : hop.postfiltered);
}

IoStatus AudioSink::push(GridView<const float> hop) {
  resampler_.push(hop);
  while (resampler_.pop(block_)) {
    if (IoStatus status = send(block_.cols()); !status.ok()) return status;
  }
  return {};
}

IoStatus AudioSink::send(std::size_t frames) {
  const GridView<const float> block(block_.data(), block_.rows(), frames, block_.cols());
  const std::span<char> bytes(bytes_.data(), frames * block_.rows() * pcm_bytes(bits_));
  clipped_ += encode_pcm(block, format_.gain, bits_, bytes);
  if (format_.unsigned_bytes) {
    for (char& byte : bytes) byte = static_cast<char>(byte ^ '\x80');
  }
  IoStatus status = writer_->write(bytes);
  well_ = status.ok();
  return status;
}

IoStatus AudioSink::close() {
  IoStatus status;
  if (well_) {
    resampler_.finish();
    while (status.ok() && resampler_.pop(block_)) status = send(block_.cols());
    if (status.ok()) {
      if (const std::size_t rest = resampler_.pop_rest(block_); rest > 0) status = send(rest);
    }
  }
  IoStatus closed = writer_->close();
  return status.ok() ? closed : status;
}

}  // namespace odas
