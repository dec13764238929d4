// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace odas {

/// The last frames of a stream, as bytes: what a recording that begins now has before it.
class SampleRing {
 public:
  SampleRing() = default;
  SampleRing(std::size_t frame_bytes, std::size_t frames)
      : frame_(frame_bytes), bytes_(frame_bytes * frames) {}

  void clear() noexcept { at_ = held_ = 0; }

  /// Whole frames.
  void push(std::span<const char> bytes) noexcept {
    if (bytes.size() > bytes_.size()) bytes = bytes.last(bytes_.size());
    const std::size_t first = std::min(bytes.size(), bytes_.size() - at_);
    std::copy_n(bytes.data(), first, bytes_.data() + at_);
    std::copy_n(bytes.data() + first, bytes.size() - first, bytes_.data());
    if (!bytes_.empty()) at_ = (at_ + bytes.size()) % bytes_.size();
    held_ = std::min(held_ + bytes.size(), bytes_.size());
  }

  /// At most so many of the last frames, the oldest first.
  [[nodiscard]] std::vector<char> last(std::size_t frames) const {
    const std::size_t count = std::min(frames * frame_, held_);
    std::vector<char> out(count);
    for (std::size_t i = 0; i < count; ++i)
      out[i] = bytes_[(at_ + bytes_.size() - count + i) % bytes_.size()];
    return out;
  }
  [[nodiscard]] std::size_t frame_bytes() const noexcept { return frame_; }

 private:
  std::size_t frame_ = 2;
  std::vector<char> bytes_;
  std::size_t at_ = 0;    // where the next byte goes
  std::size_t held_ = 0;  // bytes
};

}  // namespace odas
