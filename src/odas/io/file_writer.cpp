// SPDX-License-Identifier: MIT
#include "odas/io/file_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::size_t kBufferSize = std::size_t{64} * 1024;
constexpr std::size_t kRecords = 1024;

std::string reason(int number) {
  // The words of errno 27 speak of a size; who meets it has a limit on files (ulimit -f).
  return std::generic_category().message(number);
}

}  // namespace

FileWriter::FileWriter(std::filesystem::path file)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (!descriptor_.open()) throw IoError("cannot write " + file_.string() + ": " + reason(errno));
  buffer_.reserve(kBufferSize);
  ends_.reserve(kRecords);
}

IoStatus FileWriter::failed(int number) {
  well_ = false;
  return IoStatus::failed("cannot write " + file_.string() + ": " + reason(number));
}

IoStatus FileWriter::write(std::span<const char> record) {
  if (!well_) return {};
  const bool full = buffer_.size() + record.size() > kBufferSize || ends_.size() == kRecords;
  if (full) {
    if (IoStatus status = flush(); !status.ok()) return status;
  }
  buffer_.insert(buffer_.end(), record.begin(), record.end());
  ends_.push_back(buffer_.size());
  return {};
}

IoStatus FileWriter::flush() {
  std::size_t written = 0;
  int error = 0;
  while (well_ && written < buffer_.size() && error == 0) {
    const ssize_t n = ::write(descriptor_.get(), buffer_.data() + written, buffer_.size() - written);
    if (n > 0) written += static_cast<std::size_t>(n);
    if (n < 0 && errno != EINTR) error = errno;
    if (n == 0) error = ENOSPC;
  }
  if (error == 0) {
    size_ += written;
  } else {
    const auto torn = std::upper_bound(ends_.begin(), ends_.end(), written);
    size_ += torn == ends_.begin() ? 0 : *(torn - 1);
    // Fails for what is no regular file, which then needs no cut.
    static_cast<void>(::ftruncate(descriptor_.get(), static_cast<off_t>(size_)) == 0);
  }
  buffer_.clear();
  ends_.clear();
  return error == 0 ? IoStatus() : failed(error);
}

IoStatus FileWriter::overwrite(std::uint64_t at, std::span<const char> bytes) {
  const ssize_t n = ::pwrite(descriptor_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
  return n == static_cast<ssize_t>(bytes.size()) ? IoStatus() : failed(n < 0 ? errno : ENOSPC);
}

IoStatus FileWriter::close() {
  IoStatus status = flush();
  // Network file systems say only now that the disk is full.
  const int number = descriptor_.release();
  if (number >= 0 && ::close(number) != 0 && status.ok() && errno != EINTR) return failed(errno);
  return status;
}

}  // namespace odas
