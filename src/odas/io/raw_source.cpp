// SPDX-License-Identifier: MIT
#include "odas/io/raw_source.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

std::string words_of(int number) { return std::generic_category().message(number); }

FileDescriptor open_to_read(const std::filesystem::path& file) {
  FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor.open()) throw IoError("cannot open " + file.string() + ": " + words_of(errno));
  return descriptor;
}

}  // namespace

RawSource::RawSource(std::filesystem::path file, const RawConfig& raw)
    : file_(std::move(file)),
      channels_(static_cast<std::size_t>(raw.n_channels)),
      sample_rate_(raw.fs),
      format_(stream_format(raw)),
      descriptor_(open_to_read(file_)) {
  struct stat status {};
  if (::fstat(descriptor_.get(), &status) != 0) {
    throw IoError("cannot read " + file_.string() + ": " + words_of(errno));
  }
  if (S_ISDIR(status.st_mode)) throw IoError("cannot read " + file_.string() + ": it is a folder");
  regular_ = S_ISREG(status.st_mode);
  if (!regular_) return;
  total_ = static_cast<std::uint64_t>(status.st_size) / (channels_ * bytes_of(format_));
  if (status.st_size == 0) throw IoError(file_.string() + " is empty: there is no sound in it");
  if (*total_ == 0) {
    throw IoError(file_.string() + " holds less than one sample of " + std::to_string(channels_) +
                  " channels of " + std::string(name_of(format_)));
  }
}

ReadResult RawSource::read(GridView<float> block) {
  const std::size_t frame = channels_ * bytes_of(format_);
  const std::size_t wanted = block.cols() * frame;
  bytes_.resize(wanted);  // grows once: blocks are of one size
  ReadResult result;
  while (held_ < wanted && !ended_) {
    if (!regular_) {
      pollfd waiting{descriptor_.get(), POLLIN, 0};
      if (::poll(&waiting, 1, static_cast<int>(kReadPatience.count())) <= 0) return result;  // nothing yet
    }
    const ssize_t got = ::read(descriptor_.get(), bytes_.data() + held_, wanted - held_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      result.status = IoStatus::failed("cannot read " + file_.string() + ": " + words_of(errno));
      ended_ = true;
    }
    if (got == 0) ended_ = true;
    held_ += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
  }
  result.end = ended_;
  result.frames = held_ / frame;
  decode_samples({bytes_.data(), result.frames * frame}, format_,
                 GridView<float>(block.data(), block.rows(), result.frames, block.stride()));
  held_ -= result.frames * frame;  // at the end, the bytes of a torn frame are left
  return result;
}

std::string RawSource::warning() const {
  if (!ended_ || held_ == 0) return {};
  return file_.string() + " ends in the middle of a sample: " + std::to_string(held_) +
         " bytes are left over; is it cut, or are raw.nChannels and raw.nBits not what it was recorded with?";
}

}  // namespace odas
