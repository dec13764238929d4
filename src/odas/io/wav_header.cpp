// SPDX-License-Identifier: MIT
#include "odas/io/wav_header.hpp"

#include <cstring>

namespace odas {
namespace {

constexpr std::size_t kHead = 8;                    // of a chunk: tag, size
constexpr std::uint64_t kUnknownSize = 0x7FFFFF00;  // and above: written by those who do not know it yet

constexpr unsigned kIntegers = 1, kFloats = 3, kExtensible = 0xFFFE;

/// Whether `bytes` could be the beginning of `text`, in which '?' is any.
bool begins(std::span<const char> bytes, const char* text) noexcept {
  for (std::size_t i = 0; i < bytes.size() && text[i] != '\0'; ++i) {
    if (text[i] != '?' && text[i] != bytes[i]) return false;
  }
  return true;
}

}  // namespace

std::size_t WavHeader::push(std::span<const char> bytes) {
  std::size_t used = 0;
  while (used < bytes.size() && state_ == State::undecided) take(bytes[used++]);
  return used;
}

void WavHeader::take(char byte) {
  if (size_ < held_.size()) held_[size_++] = byte;
  switch (part_) {
    case Part::magic:
      if (begins(taken(), "fLaC") && size_ == 4) {
        fail("is FLAC, which cannot be read from a stream; decode it first: flac -dc FILE | ...");
      } else if (!begins(taken(), "RIFF????WAVE") && !begins(taken(), "RF64????WAVE") &&
                 !begins(taken(), "fLaC")) {
        state_ = State::headerless;
      } else if (size_ == kMagic) {
        begin_chunk();
      }
      return;
    case Part::chunk_head:
      if (size_ < kHead) return;
      std::memcpy(tag_.data(), held_.data(), 4);
      left_ = number(4, 4);
      size_ = 0;
      if (std::memcmp(tag_.data(), "data", 4) == 0) {
        if (!known_) return fail("is a WAV without a format before its samples");
        format_.bytes = left_ == 0xFFFFFFFF && long_size_ != 0 ? long_size_ : left_;
        if (format_.bytes == left_ && (left_ == 0 || left_ >= kUnknownSize)) format_.bytes = kEndless;
        state_ = State::samples;
        return;
      }
      left_ += left_ & 1U;  // chunks are padded to even sizes
      part_ = Part::chunk_body;
      if (left_ == 0) end_chunk();
      return;
    case Part::chunk_body:
      if (--left_ == 0) end_chunk();
      return;
  }
}

void WavHeader::begin_chunk() {
  part_ = Part::chunk_head;
  size_ = 0;
}

void WavHeader::end_chunk() {
  if (std::memcmp(tag_.data(), "fmt ", 4) == 0) read_format();
  if (std::memcmp(tag_.data(), "ds64", 4) == 0 && size_ >= 16) long_size_ = number(8, 8);
  if (state_ == State::undecided) begin_chunk();
}

void WavHeader::read_format() {
  if (size_ < 16) return fail("is a WAV with a format of less than 16 bytes");
  auto coding = static_cast<unsigned>(number(0, 2));
  if (coding == kExtensible && size_ >= 26) coding = static_cast<unsigned>(number(24, 2));
  format_.channels = number(2, 2);
  format_.sample_rate = static_cast<int>(number(4, 4) & 0x7FFFFFFFU);
  const std::uint64_t bits = number(14, 2);
  const std::string text = std::to_string(bits);
  if (coding == kFloats && bits == 32) {
    format_.samples = SampleFormat::f32;
  } else if (coding == kIntegers && (bits == 8 || bits == 16 || bits == 24 || bits == 32)) {
    format_.samples = bits == 8    ? SampleFormat::u8
                      : bits == 16 ? SampleFormat::s16
                      : bits == 24 ? SampleFormat::s24_3
                                   : SampleFormat::s32;
  } else {
    return fail("is a WAV of coding " + std::to_string(coding) + " with " + text +
                " bits; only integers of 8, 16, 24 or 32 bits and floats of 32 can be read from a stream");
  }
  known_ = true;
}

void WavHeader::fail(std::string why) {
  state_ = State::broken;
  fault_ = std::move(why);
}

std::uint64_t WavHeader::number(std::size_t at, std::size_t bytes) const noexcept {
  std::uint64_t value = 0;
  std::memcpy(&value, held_.data() + at, bytes);
  return value;
}

}  // namespace odas
