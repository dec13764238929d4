// SPDX-License-Identifier: MIT
#include "odas/io/stream_intake.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::size_t kShown = 32;
constexpr HopIndex kLongestGap = 1'000'000;  // hops: beyond it a stamp is taken for nonsense

bool is_object_of_text(std::span<const char> bytes) {
  std::string_view text(bytes.data(), std::min<std::size_t>(bytes.size(), 64));
  const auto skip_space = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  };
  skip_space();
  if (!text.starts_with('{')) return false;
  text.remove_prefix(1);
  skip_space();
  return text.starts_with("\"timeStamp\"");
}

}  // namespace

std::string excerpt(std::string_view bytes) {
  std::string shown;
  for (const char c : bytes.substr(0, kShown)) {
    const auto byte = static_cast<unsigned char>(c);
    shown += byte >= 0x20 && byte < 0x7F ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
  }
  return bytes.size() > kShown ? shown + "..." : shown;
}

IoStatus TextIntake::take(std::span<const char> bytes) {
  cutter_.push({bytes.data(), bytes.size()});
  while (const auto cut = cutter_.next()) {
    if (cut->fault != nullptr) {
      refuse(cut->text, cut->fault);
      continue;
    }
    const StreamRecord record = read_stream_record(cut->text, expected_);
    if (!record.is_good()) {
      refuse(cut->text, record.fault);
      continue;
    }
    count(record);
    if (IoStatus status = receive_(record, cut->text); !status.ok()) return status;
  }
  return {};
}

void TextIntake::refuse(std::string_view text, const std::string& fault) {
  if (refused_++ > 0) return;
  // Built with _FORTIFY_SOURCE, as Ubuntu does, ODAS sends the end of each object alone.
  const bool is_fortified = text.starts_with("}\n");
  say_(fmt::format("what came {}: \"{}\"; {}", fault, excerpt(text),
                   is_fortified ? "ODAS sends this if it was built with _FORTIFY_SOURCE: build it without "
                                  "(its issue 293), or use odaslive of this project"
                                : "it is passed over, and more of its kind is counted"));
}

void TextIntake::count(const StreamRecord& record) {
  HopIndex& last = last_[static_cast<std::size_t>(record.kind)];
  ++hops_;
  if (last != 0 && record.time > last && record.time - last <= kLongestGap)
    missing_ += record.time - last - 1;
  last = record.time;
}

std::string TextIntake::amount() const {
  std::string text = fmt::format("{} hops", hops_);
  if (missing_ > 0) text += fmt::format(", {} missing", missing_);
  if (refused_ > 0) text += fmt::format(", {} pieces of nonsense", refused_);
  return text;
}

AudioIntake::AudioIntake(const WavWriter::Format& format, Open open, Say say)
    : format_(format),
      open_(std::move(open)),
      say_(std::move(say)),
      frame_size_(format.channels * static_cast<std::size_t>(format.bits) / 8) {}

IoStatus AudioIntake::take(std::span<const char> bytes) {
  if (!begun_ && is_object_of_text(bytes)) {
    is_text_ = true;
    say_("what came is text and no sound: the ports of the sender are mixed up; it is passed over");
  }
  begun_ = true;
  if (is_text_) return {};
  pending_.insert(pending_.end(), bytes.begin(), bytes.end());
  const std::size_t whole = pending_.size() / frame_size_ * frame_size_;
  if (whole == 0) return {};
  if (!file_) {
    try {
      file_ = open_(format_);
    } catch (const IoError& error) { return IoStatus::failed(error.what()); }
  }
  const std::span<char> frames = std::span(pending_).first(whole);
  if (format_.bits == 8) {
    for (char& sample : frames) sample = static_cast<char>(sample ^ 0x80);  // WAV has 8 bits unsigned
  }
  IoStatus status = file_->write(frames);
  frames_ += whole / frame_size_;
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(whole));
  return status;
}

IoStatus AudioIntake::close() {
  if (!pending_.empty()) {
    say_(
        fmt::format("the last {} bytes are no whole sample of {} channels of {} bits, and are left out; if "
                    "it sounds wrong, look at --channels and --bits",
                    pending_.size(), format_.channels, format_.bits));
    pending_.clear();
  }
  return file_ ? file_->close() : IoStatus();
}

std::string AudioIntake::file() const {
  return file_ ? std::filesystem::path(file_->where()).filename().string() : "";
}

std::string AudioIntake::amount() const {
  return fmt::format("{:.1f} s", static_cast<double>(frames_) / format_.sample_rate);
}

}  // namespace odas
