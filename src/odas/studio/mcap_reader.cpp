// SPDX-License-Identifier: MIT
#include "odas/studio/mcap_reader.hpp"

#include <algorithm>
#include <utility>

#include "odas/base/error.hpp"
#include "odas/studio/little_endian.hpp"

namespace odas {
namespace {

constexpr std::uint64_t kLongestRecord = std::uint64_t{64} << 20;
constexpr std::size_t kChunkHead = 8 + 8 + 8 + 4;  // before the name of its compression
constexpr std::size_t kFooter = kMcapRecordHead + 20;

std::pair<std::uint16_t, McapChannel> channel_in(std::span<const char> record) {
  LittleEndianReader in(record);
  const auto id = in.take<std::uint16_t>();
  in.take<std::uint16_t>();  // schema
  McapChannel channel;
  channel.topic = in.take_text();
  channel.encoding = in.take_text();
  return {id, channel};
}

}  // namespace

McapReader::McapReader(const std::filesystem::path& file) : file_(file, std::ios::binary) {
  if (!file_) throw IoError("cannot read " + file.string() + ": is it there?");
  file_.seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(file_.tellg(), 0));
  file_.seekg(0);
  std::vector<char> magic;
  if (!read(kMcapMagic.size(), magic) || std::string_view(magic.data(), magic.size()) != kMcapMagic) {
    throw IoError(file.string() + " is no session: it does not begin as MCAP does");
  }
  if (read_record() == McapOp::header) profile_ = LittleEndianReader(record_).take_text();
}

bool McapReader::read(std::size_t bytes, std::vector<char>& to) {
  to.resize(bytes);
  file_.read(to.data(), static_cast<std::streamsize>(bytes));
  const auto got = static_cast<std::size_t>(file_.gcount());
  at_ += got;
  to.resize(got);
  return got == bytes;
}

void McapReader::check_chunk() {
  if (chunk_end_ != 0 && at_ >= chunk_end_) {
    if (chunk_sum_ != 0 && sum_.value() != chunk_sum_ && fault_.empty()) fault_ = "is damaged";
    chunk_end_ = 0;
  }
}

bool McapReader::enter_chunk(std::uint64_t length) {
  std::vector<char> head, name;
  const std::uint64_t begin = at_;
  if (!read(kChunkHead + 4, head)) return false;
  LittleEndianReader in(head);
  in.take_bytes(8 + 8 + 8);
  chunk_sum_ = in.take<std::uint32_t>();
  if (in.take<std::uint32_t>() != 0) {
    fault_ = "is compressed; decompress it first: mcap compress --compression none";
    return false;
  }
  chunk_end_ = begin + length;
  sum_ = {};
  return read(8, name);  // length of the records: up to the end
}

std::optional<McapOp> McapReader::read_record() {
  for (;;) {
    check_chunk();
    std::vector<char> head;
    const bool whole = read(kMcapRecordHead, head);
    LittleEndianReader in(head);
    const auto op = static_cast<McapOp>(in.take<std::uint8_t>());
    const auto length = in.take<std::uint64_t>();
    if (!whole || (op != McapOp::chunk && length > size_ - at_)) {
      // A length that reaches beyond the end of a file with a footer is nonsense, and no cut.
      if (fault_.empty()) fault_ = statistics() ? "is damaged" : "was cut off";
      return std::nullopt;
    }
    if (op == McapOp::chunk) {
      if (!enter_chunk(length)) {
        if (fault_.empty()) fault_ = "was cut off";
        return std::nullopt;
      }
      continue;
    }
    if (length > kLongestRecord) {
      fault_ = "is damaged";
      return std::nullopt;
    }
    if (!read(static_cast<std::size_t>(length), record_)) {
      fault_ = "cannot be read";
      return std::nullopt;
    }
    if (chunk_end_ != 0) {
      sum_.add(head);
      sum_.add(record_);
    }
    return op;
  }
}

std::optional<McapMessage> McapReader::next() {
  while (const std::optional<McapOp> op = read_record()) {
    if (*op == McapOp::data_end || *op == McapOp::footer) return std::nullopt;
    if (*op == McapOp::channel) {
      auto [id, channel] = channel_in(record_);
      channels_.insert_or_assign(id, std::move(channel));
    }
    if (*op != McapOp::message) continue;
    LittleEndianReader in(record_);
    const auto found = channels_.find(in.take<std::uint16_t>());
    in.take<std::uint32_t>();
    const auto time = in.take<std::uint64_t>();
    in.take<std::uint64_t>();
    if (in.ok() && found != channels_.end()) return McapMessage{&found->second, time, in.rest()};
  }
  return std::nullopt;
}

template <class Take>
void McapReader::read_summary(Take take) {
  std::vector<char> bytes;
  file_.clear();
  const std::uint64_t back = at_;
  const auto go = [&](std::uint64_t to) {
    at_ = to;
    file_.seekg(static_cast<std::streamoff>(to));
  };
  if (size_ >= kFooter + 2 * kMcapMagic.size()) {
    go(size_ - kFooter - kMcapMagic.size());
    const bool whole = read(kFooter + kMcapMagic.size(), bytes) &&
                       std::string_view(bytes.data() + kFooter, kMcapMagic.size()) == kMcapMagic;
    LittleEndianReader in(bytes);
    const bool footer = static_cast<McapOp>(in.take<std::uint8_t>()) == McapOp::footer;
    in.take<std::uint64_t>();
    const auto start = in.take<std::uint64_t>();
    const std::uint64_t end = size_ - kFooter - kMcapMagic.size();
    if (whole && footer && start != 0 && start < end && end - start < kLongestRecord) {
      go(start);
      if (read(static_cast<std::size_t>(end - start), bytes)) {
        LittleEndianReader records(bytes);
        while (!records.rest().empty()) {
          const auto op = static_cast<McapOp>(records.take<std::uint8_t>());
          const auto content = records.take_bytes(static_cast<std::size_t>(records.take<std::uint64_t>()));
          if (!records.ok()) break;
          take(op, content);
        }
      }
    }
  }
  file_.clear();
  go(back);
}

std::optional<McapStatistics> McapReader::statistics() {
  std::optional<McapStatistics> found;
  read_summary([&](McapOp op, std::span<const char> content) {
    if (op != McapOp::statistics) return;
    LittleEndianReader in(content);
    McapStatistics all;
    all.messages = in.take<std::uint64_t>();
    in.take<std::uint16_t>();
    all.channels = in.take<std::uint32_t>();
    in.take<std::uint64_t>();
    all.chunks = in.take<std::uint32_t>();
    all.begin_ns = in.take<std::uint64_t>();
    all.end_ns = in.take<std::uint64_t>();
    if (in.ok()) found = all;
  });
  return found;
}

std::vector<McapChannel> McapReader::summary_channels() {
  std::vector<McapChannel> found;
  read_summary([&](McapOp op, std::span<const char> content) {
    if (op == McapOp::channel) found.push_back(channel_in(content).second);
  });
  return found;
}

}  // namespace odas
