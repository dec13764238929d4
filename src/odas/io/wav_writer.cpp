// SPDX-License-Identifier: MIT
#include "odas/io/wav_writer.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::uint64_t kHeaderSize = 44;
using Header = std::array<char, kHeaderSize>;

template <class Int>
char* put(char* to, Int value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}
char* put_tag(char* to, const char* tag) {
  std::memcpy(to, tag, 4);
  return to + 4;
}

/// RIFF header of a file of `size` bytes in all.
Header header_of(const WavWriter::Format& format, std::uint64_t size) {
  const auto limited = [](std::uint64_t n) {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(n, std::numeric_limits<std::uint32_t>::max()));
  };
  const auto bytes = static_cast<std::uint32_t>(format.bits / 8);
  const auto channels = static_cast<std::uint32_t>(format.channels);
  const auto rate = static_cast<std::uint32_t>(format.sample_rate);
  Header header;
  char* to = put(put_tag(header.data(), "RIFF"), limited(size - 8));
  to = put(put_tag(put_tag(to, "WAVE"), "fmt "), std::uint32_t{16});
  to = put(put(to, std::uint16_t{1}), static_cast<std::uint16_t>(channels));  // 1: integer PCM
  to = put(put(to, rate), rate * channels * bytes);
  to = put(put(to, static_cast<std::uint16_t>(channels * bytes)), static_cast<std::uint16_t>(format.bits));
  put(put_tag(to, "data"), limited(size - kHeaderSize));
  return header;
}

}  // namespace

WavWriter::WavWriter(std::filesystem::path file, Format format) : file_(std::move(file)), format_(format) {
  IoStatus status = file_.write(header_of(format_, kHeaderSize));
  if (status.ok()) status = file_.flush();
  if (!status.ok()) throw IoError(status.what());
}

IoStatus WavWriter::update_header() {
  if (file_.size() < kHeaderSize) return {};
  return file_.overwrite(0, header_of(format_, file_.size()));
}

IoStatus WavWriter::flush() {
  if (IoStatus status = file_.flush(); !status.ok()) return status;
  return update_header();
}

IoStatus WavWriter::close() {
  IoStatus written = file_.flush();
  IoStatus updated = update_header();
  IoStatus closed = file_.close();
  return !written.ok() ? written : !updated.ok() ? updated : closed;
}

}  // namespace odas
