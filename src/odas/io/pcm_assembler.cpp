// SPDX-License-Identifier: MIT
#include "odas/io/pcm_assembler.hpp"

#include <algorithm>
#include <utility>

namespace odas {

PcmAssembler::PcmAssembler(Expected expected, std::size_t capacity)
    : expected_(expected),
      format_(expected.samples),
      ready_(expected.channels, capacity + WavHeader::kMagic) {
  ODAS_EXPECT(expected.channels > 0 && capacity > 0);
}

std::size_t PcmAssembler::push(std::span<const char> bytes) {
  std::size_t used = 0;
  if (header_.state() == WavHeader::State::undecided) {
    // What turns out to be no header must find room, or the channels would slip.
    if (frames() + WavHeader::kMagic > ready_.cols()) return 0;
    used = header_.push(bytes);
    if (header_.state() == WavHeader::State::undecided) return used;
    accept_header();
  }
  if (over_ || !fault_.empty()) return bytes.size();
  return used + push_samples(bytes.subspan(used));
}

void PcmAssembler::accept_header() {
  const WavHeader::Format& format = header_.format();
  switch (header_.state()) {
    case WavHeader::State::headerless:
      push_samples(header_.taken());
      return;
    case WavHeader::State::samples:
      if (format.channels != expected_.channels) {
        fault_ = "has " + std::to_string(format.channels) + " channels, but raw.nChannels is " +
                 std::to_string(expected_.channels);
      } else if (format.sample_rate != expected_.sample_rate) {
        fault_ = "has " + std::to_string(format.sample_rate) + " Hz, but raw.fS is " +
                 std::to_string(expected_.sample_rate);
      }
      format_ = format.samples;
      left_ = format.bytes;
      return;
    case WavHeader::State::broken:
      fault_ = header_.fault();
      return;
    case WavHeader::State::undecided:
      return;
  }
}

void PcmAssembler::make_room() {
  if (begin_ == 0) return;
  for (std::size_t c = 0; c < ready_.rows(); ++c) {
    std::copy(ready_[c].data() + begin_, ready_[c].data() + end_, ready_[c].data());
  }
  end_ -= begin_;
  begin_ = 0;
}

std::size_t PcmAssembler::push_samples(std::span<const char> bytes) {
  const std::size_t frame = expected_.channels * bytes_of(format_);
  make_room();
  const auto append = [&](std::span<const char> whole) {
    const std::size_t n = whole.size() / frame;
    decode_samples(whole, format_, GridView<float>(ready_.data() + end_, ready_.rows(), n, ready_.cols()));
    end_ += n;
  };
  const std::size_t all = bytes.size();
  const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left_, all));
  std::span<const char> rest = bytes.first(wanted);
  if (!torn_.empty() && end_ < ready_.cols()) {
    const std::size_t n = std::min(frame - torn_.size(), rest.size());
    torn_.insert(torn_.end(), rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(n));
    rest = rest.subspan(n);
    if (torn_.size() == frame) {
      append(torn_);
      torn_.clear();
    }
  }
  if (torn_.empty()) {
    const std::size_t whole = std::min(rest.size() / frame, ready_.cols() - end_) * frame;
    append(rest.first(whole));
    rest = rest.subspan(whole);
    if (rest.size() < frame) {
      torn_.assign(rest.begin(), rest.end());
      rest = {};
    }
  }
  const std::size_t used = wanted - rest.size();
  if (left_ != WavHeader::kEndless) left_ -= used;
  over_ = left_ == 0;
  return over_ ? all : used;
}

std::size_t PcmAssembler::pop(GridView<float> block) noexcept {
  ODAS_EXPECT(block.rows() == ready_.rows());
  const std::size_t n = std::min(block.cols(), frames());
  for (std::size_t c = 0; c < block.rows(); ++c) std::copy_n(ready_[c].data() + begin_, n, block[c].data());
  begin_ += n;
  if (begin_ == end_) begin_ = end_ = 0;
  return n;
}

std::size_t PcmAssembler::finish() {
  // A stream that ended before it could have been told from a WAV was samples.
  if (header_.state() == WavHeader::State::undecided) push_samples(header_.taken());
  header_ = WavHeader();
  format_ = expected_.samples;
  left_ = WavHeader::kEndless;
  over_ = false;
  fault_.clear();
  const std::size_t torn = torn_.size();
  torn_.clear();
  return torn;
}

}  // namespace odas
