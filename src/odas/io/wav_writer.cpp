// SPDX-License-Identifier: MIT
#include "odas/io/wav_writer.hpp"

#include <cstring>
#include <limits>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::uint32_t kSize64 = 28;  // bytes of a ds64 chunk without a table
constexpr std::uint64_t kMost32 = std::numeric_limits<std::uint32_t>::max();

template <class Int>
char* put(char* to, Int value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}
char* put_tag(char* to, const char* tag) {
  std::memcpy(to, tag, 4);
  return to + 4;
}

}  // namespace

WavHeaderBytes wav_header(const WavWriter::Format& format, std::uint64_t size) {
  const bool large = size - 8 > kMost32;
  const auto in_32 = [&](std::uint64_t n) { return static_cast<std::uint32_t>(large ? kMost32 : n); };
  const auto bytes = static_cast<std::uint32_t>(format.bits / 8);
  const auto channels = static_cast<std::uint32_t>(format.channels);
  const auto rate = static_cast<std::uint32_t>(format.sample_rate);
  const std::uint64_t data = size - kWavHeaderSize;
  WavHeaderBytes header{};
  char* to = put(put_tag(header.data(), large ? "RF64" : "RIFF"), in_32(size - 8));
  to = put(put_tag(put_tag(to, "WAVE"), large ? "ds64" : "JUNK"), kSize64);
  if (large) put(put(put(to, size - 8), data), data / (bytes * channels));
  to = put(put_tag(to + kSize64, "fmt "), std::uint32_t{16});
  to = put(put(to, std::uint16_t{1}), static_cast<std::uint16_t>(channels));  // 1: integer PCM
  to = put(put(to, rate), rate * channels * bytes);
  to = put(put(to, static_cast<std::uint16_t>(channels * bytes)), static_cast<std::uint16_t>(format.bits));
  put(put_tag(to, "data"), in_32(data));
  return header;
}

WavWriter::WavWriter(std::filesystem::path file, Format format) : file_(std::move(file)), format_(format) {
  IoStatus status = file_.write(wav_header(format_, kWavHeaderSize));
  if (status.ok()) status = file_.flush();
  if (!status.ok()) throw IoError(status.what());
}

IoStatus WavWriter::update_header() {
  if (file_.size() < kWavHeaderSize) return {};
  return file_.overwrite(0, wav_header(format_, file_.size()));
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
