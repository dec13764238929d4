// SPDX-License-Identifier: MIT
#include "odas/io/stream_source.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <thread>
#include <utility>

#include <poll.h>
#include <unistd.h>

namespace odas {
namespace {

constexpr auto kPause = std::chrono::milliseconds(5);  // between two looks for a peer
constexpr std::size_t kReadBytes = std::size_t{64} * 1024;

void say(ReadResult& result, const std::string& text) {
  result.notice += (result.notice.empty() ? "" : "; ") + text;
}

int milliseconds_until(std::chrono::steady_clock::time_point deadline) {
  const auto left = deadline - std::chrono::steady_clock::now();
  return static_cast<int>(
      std::max<std::int64_t>(0, std::chrono::duration_cast<std::chrono::milliseconds>(left).count()));
}

}  // namespace

StreamSource::StreamSource(const RawConfig& raw, std::unique_ptr<StreamPort> port)
    : channels_(static_cast<std::size_t>(raw.n_channels)),
      sample_rate_(raw.fs),
      reconnect_(raw.interface.reconnect),
      port_(std::move(port)),
      assembler_({stream_format(raw), channels_, raw.fs}, 2 * static_cast<std::size_t>(raw.hop_size)),
      bytes_(kReadBytes),
      away_(raw.fs) {}

ReadResult StreamSource::read(GridView<float> block) {
  ReadResult result;
  const Clock::time_point deadline = Clock::now() + kReadPatience;
  const std::size_t wanted = std::min(block.cols(), assembler_.capacity());
  while (assembler_.frames() < wanted && !ended_) {
    if (!stream_.open() && at_ == held_) {
      // What came before the stream ended is given first, so that the gap comes after it.
      if (assembler_.frames() > 0) break;
      wait_for_stream(result, deadline);
    }
    if (stream_.open() || at_ < held_) take(result, deadline, wanted);
    if (Clock::now() >= deadline) break;
  }
  // Whole blocks only, so that the blocks do not depend on how the stream was cut; but for its end.
  if (assembler_.frames() >= wanted || !stream_.open()) {
    result.frames = assembler_.pop(block);
    if (result.frames > 0) result.lost += away_.take(Clock::now());
  }
  result.end = ended_ && assembler_.frames() == 0;
  if (result.end) result.status = fault_;
  return result;
}

void StreamSource::wait_for_stream(ReadResult& result, Clock::time_point deadline) {
  for (;;) {
    result.lost += away_.take(Clock::now());
    if (std::optional<FileDescriptor> stream = port_->poll(result.notice)) {
      stream_ = std::move(*stream);
      received_ = 0;
      return;
    }
    if (Clock::now() >= deadline) return;
    std::this_thread::sleep_for(kPause);
  }
}

void StreamSource::take(ReadResult& result, Clock::time_point deadline, std::size_t wanted) {
  if (at_ == held_ && stream_.open()) {
    port_->refuse_others(result.notice);
    pollfd readable{stream_.get(), POLLIN, 0};
    if (::poll(&readable, 1, milliseconds_until(deadline)) <= 0) {
      result.lost += away_.take(Clock::now());
      return;
    }
    const ssize_t got = ::read(stream_.get(), bytes_.data(), bytes_.size());
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (got <= 0) return stream_over(result, got < 0 ? errno : 0);
    if (away_.running()) {
      result.lost += away_.take(Clock::now());
      away_.stop();
    }
    received_ += static_cast<std::uint64_t>(got);
    at_ = 0;
    held_ = static_cast<std::size_t>(got);
  }
  while (at_ < held_ && assembler_.frames() < wanted) {
    at_ += assembler_.push({bytes_.data() + at_, held_ - at_});
  }
  if (assembler_.over() || !assembler_.fault().empty()) {
    at_ = held_;
    stream_over(result, 0);
  }
}

void StreamSource::stream_over(ReadResult& result, int error) {
  const std::string fault = assembler_.fault();
  const bool heard = received_ > 0;
  stream_ = FileDescriptor();
  const std::size_t torn = assembler_.finish();
  const std::string where = port_->where();
  const std::string torn_text =
      torn == 0 ? "" : " in the middle of a sample (" + std::to_string(torn) + " bytes are left over)";
  if (!fault.empty()) {
    fault_ = IoStatus::failed("what " + where + " sends " + fault);
    ended_ = true;
  } else if (error != 0 && !port_->can_return()) {
    fault_ = IoStatus::failed("cannot read " + where + ": " + std::generic_category().message(error));
    ended_ = true;
  } else if (!port_->can_return() || (error == 0 && heard && !reconnect_)) {
    ended_ = true;
    if (torn > 0) {
      warning_ = where + " ended" + torn_text +
                 "; did it break off, or are raw.nChannels, raw.nBits and raw.format not what it sends?";
    }
  } else {
    say(result, where +
                    (error != 0 ? " was lost (" + std::generic_category().message(error) + ")"
                     : heard    ? " has closed"
                                : " closed without a sample") +
                    torn_text + "; it is waited for");
    if (heard && !away_.running()) away_.start(Clock::now());
  }
}

}  // namespace odas
