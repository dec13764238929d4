// SPDX-License-Identifier: MIT
#include "odas/studio/zip.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>

#include "odas/base/error.hpp"
#include "odas/studio/crc32.hpp"
#include "odas/studio/little_endian.hpp"

namespace odas {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kShort = 0xFFFFFFFF;
constexpr std::uint16_t kUtf8 = 1U << 11;
constexpr std::uint16_t kVersion = 20, kLongVersion = 45;
constexpr std::uint16_t kLongTag = 1;

std::uint32_t in_short(std::uint64_t number, bool is_long) {
  return is_long ? kShort : static_cast<std::uint32_t>(number);
}

/// Date and time as DOS had them, UTC.
std::uint32_t dos_time(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  const auto since = std::chrono::file_clock::to_sys(error ? fs::file_time_type::clock::now() : time);
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(since));
  std::tm t{};
  ::gmtime_r(&seconds, &t);
  const auto part = [](int value, int shift) {
    return static_cast<std::uint32_t>(std::max(value, 0)) << shift;
  };
  return part(t.tm_year - 80, 25) | part(t.tm_mon + 1, 21) | part(t.tm_mday, 16) | part(t.tm_hour, 11) |
         part(t.tm_min, 5) | part(t.tm_sec / 2, 0);
}

}  // namespace

ZipWriter::ZipWriter(fs::path file, bool always_long)
    : path_(std::move(file)), file_(path_, std::ios::binary | std::ios::trunc), always_long_(always_long) {
  if (!file_) throw IoError("cannot write " + path_.string() + ": is the folder ours?");
}

void ZipWriter::put(const std::vector<char>& bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_) throw IoError("cannot write " + path_.string() + ": is the disk full?");
}

std::vector<char> ZipWriter::local_header(const Entry& entry) const {
  const bool large = is_long(entry.size);
  std::vector<char> bytes;
  put_le(bytes, std::uint32_t{0x04034B50});
  put_le(bytes, large ? kLongVersion : kVersion);
  put_le(bytes, kUtf8);
  put_le(bytes, std::uint16_t{0});  // stored
  put_le(bytes, entry.time);
  put_le(bytes, entry.sum);
  put_le(bytes, in_short(entry.size, large));
  put_le(bytes, in_short(entry.size, large));
  put_le(bytes, static_cast<std::uint16_t>(entry.name.size()));
  put_le(bytes, static_cast<std::uint16_t>(large ? 20 : 0));
  put_bytes(bytes, entry.name);
  if (large) {
    put_le(bytes, kLongTag);
    put_le(bytes, std::uint16_t{16});
    put_le(bytes, entry.size);
    put_le(bytes, entry.size);
  }
  return bytes;
}

void ZipWriter::add(const fs::path& file, const std::string& name) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) throw IoError("cannot read " + file.string() + ": is it there?");
  Entry entry{name, static_cast<std::uint64_t>(in.tellg()), static_cast<std::uint64_t>(file_.tellp()), 0,
              dos_time(file)};
  in.seekg(0);
  put(local_header(entry));
  Crc32 sum;
  std::vector<char> piece(std::size_t{1} << 16);
  for (std::uint64_t left = entry.size; left > 0;) {
    piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(left, piece.size())));
    if (!in.read(piece.data(), static_cast<std::streamsize>(piece.size()))) {
      throw IoError("cannot read " + file.string() + ": it has become shorter");
    }
    sum.add(piece);
    put(piece);
    left -= piece.size();
  }
  entry.sum = sum.value();
  const auto end = file_.tellp();
  file_.seekp(static_cast<std::streamoff>(entry.at));
  put(local_header(entry));
  file_.seekp(end);
  entries_.push_back(std::move(entry));
}

std::vector<char> ZipWriter::directory(std::uint64_t at) const {
  std::vector<char> bytes;
  for (const Entry& entry : entries_) {
    const bool large = is_long(entry.size) || is_long(entry.at);
    put_le(bytes, std::uint32_t{0x02014B50});
    put_le(bytes, static_cast<std::uint16_t>(0x0300 | kLongVersion));  // made on Unix
    put_le(bytes, large ? kLongVersion : kVersion);
    put_le(bytes, kUtf8);
    put_le(bytes, std::uint16_t{0});
    put_le(bytes, entry.time);
    put_le(bytes, entry.sum);
    put_le(bytes, in_short(entry.size, large));
    put_le(bytes, in_short(entry.size, large));
    put_le(bytes, static_cast<std::uint16_t>(entry.name.size()));
    put_le(bytes, static_cast<std::uint16_t>(large ? 28 : 0));
    for (int i = 0; i < 3; ++i) put_le(bytes, std::uint16_t{0});  // comment, disk, attributes within
    put_le(bytes, std::uint32_t{0100644U << 16});
    put_le(bytes, in_short(entry.at, large));
    put_bytes(bytes, entry.name);
    if (!large) continue;
    put_le(bytes, kLongTag);
    put_le(bytes, std::uint16_t{24});
    put_le(bytes, entry.size);
    put_le(bytes, entry.size);
    put_le(bytes, entry.at);
  }
  const std::uint64_t size = bytes.size(), count = entries_.size();
  const bool large = is_long(at) || is_long(size) || count >= 0xFFFF;
  if (large) {
    put_le(bytes, std::uint32_t{0x06064B50});
    put_le(bytes, std::uint64_t{44});
    put_le(bytes, static_cast<std::uint16_t>(0x0300 | kLongVersion));
    put_le(bytes, kLongVersion);
    put_le(bytes, std::uint64_t{0});  // disks
    for (const std::uint64_t number : {count, count, size, at}) put_le(bytes, number);
    put_le(bytes, std::uint32_t{0x07064B50});
    put_le(bytes, std::uint32_t{0});
    put_le(bytes, at + size);
    put_le(bytes, std::uint32_t{1});
  }
  const auto short_count = static_cast<std::uint16_t>(large ? 0xFFFF : count);
  put_le(bytes, std::uint32_t{0x06054B50});
  put_le(bytes, std::uint32_t{0});  // disks
  put_le(bytes, short_count);
  put_le(bytes, short_count);
  put_le(bytes, in_short(size, large));
  put_le(bytes, in_short(at, large));
  put_le(bytes, std::uint16_t{0});
  return bytes;
}

void ZipWriter::close() {
  put(directory(static_cast<std::uint64_t>(file_.tellp())));
  file_.close();
  if (!file_) throw IoError("cannot write " + path_.string() + ": is the disk full?");
}

}  // namespace odas
