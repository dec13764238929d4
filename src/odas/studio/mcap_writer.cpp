// SPDX-License-Identifier: MIT
#include "odas/studio/mcap_writer.hpp"

#include <algorithm>

#include "odas/base/error.hpp"
#include "odas/studio/crc32.hpp"
#include "odas/studio/little_endian.hpp"

namespace odas {
namespace {

constexpr std::size_t kLongestChunk = std::size_t{4} << 20;
constexpr std::uint16_t kAnyObject = 1;  // the only schema

void put_record(std::vector<char>& to, McapOp op, std::span<const char> content) {
  put_le(to, static_cast<std::uint8_t>(op));
  put_le(to, static_cast<std::uint64_t>(content.size()));
  put_bytes(to, content);
}

std::vector<char> schema_record() {
  std::vector<char> content, record;
  put_le(content, kAnyObject);
  put_le_text(content, "object");
  put_le_text(content, "jsonschema");
  put_le_text(content, R"({"type":"object"})");
  put_record(record, McapOp::schema, content);
  return record;
}

/// A map of numbers, after its length in bytes.
template <class Pairs>
void put_map(std::vector<char>& to, const Pairs& pairs) {
  std::vector<char> content;
  for (const auto& [key, value] : pairs) {
    put_le(content, key);
    put_le(content, value);
  }
  put_le(to, static_cast<std::uint32_t>(content.size()));
  put_bytes(to, content);
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& file, std::string_view library) : file_(file) {
  std::vector<char> content, bytes;
  put_le_text(content, "odas");
  put_le_text(content, library);
  put_bytes(bytes, kMcapMagic);
  put_record(bytes, McapOp::header, content);
  IoStatus status = put(bytes);
  if (status.ok()) status = file_.flush();
  if (!status.ok()) throw IoError(status.what());
}

IoStatus McapWriter::put(std::span<const char> bytes) {
  at_ += bytes.size();
  return file_.write(bytes);
}

std::uint16_t McapWriter::add_channel(const McapChannel& channel) {
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  const bool json = channel.encoding == "json";
  std::vector<char> content;
  put_le(content, id);
  put_le(content, json ? kAnyObject : std::uint16_t{0});
  put_le_text(content, channel.topic);
  put_le_text(content, channel.encoding);
  put_le(content, std::uint32_t{0});  // no metadata
  Channel added;
  put_record(added.record, McapOp::channel, content);
  channels_.push_back(std::move(added));
  return id;
}

IoStatus McapWriter::write(std::uint16_t channel, std::uint64_t time, std::span<const char> data) {
  Channel& to = channels_.at(channel - 1U);
  if (!to.written) {
    if (!std::exchange(has_schema_, true)) put_bytes(chunk_, schema_record());
    put_bytes(chunk_, to.record);
    to.written = true;
  }
  to.index.emplace_back(time, chunk_.size());
  put_le(chunk_, static_cast<std::uint8_t>(McapOp::message));
  put_le(chunk_, static_cast<std::uint64_t>(22 + data.size()));
  put_le(chunk_, channel);
  put_le(chunk_, to.sequence++);
  put_le(chunk_, time);  // logged
  put_le(chunk_, time);  // published
  put_bytes(chunk_, data);
  waiting_.begin_ns = empty_ ? time : std::min(waiting_.begin_ns, time);
  waiting_.end_ns = empty_ ? time : std::max(waiting_.end_ns, time);
  empty_ = false;
  return chunk_.size() > kLongestChunk ? put_chunk() : IoStatus();
}

IoStatus McapWriter::put_chunk() {
  if (chunk_.empty()) return {};
  Chunk chunk = std::exchange(waiting_, {});
  chunk.at = at_;
  chunk.content = chunk_.size();
  std::vector<char> bytes;
  put_le(bytes, static_cast<std::uint8_t>(McapOp::chunk));
  put_le(bytes, std::uint64_t{8 + 8 + 8 + 4 + 4 + 8} + chunk_.size());
  put_le(bytes, chunk.begin_ns);
  put_le(bytes, chunk.end_ns);
  put_le(bytes, static_cast<std::uint64_t>(chunk_.size()));
  put_le(bytes, crc32_of(chunk_));
  put_le_text(bytes, "");  // no compression
  put_le(bytes, static_cast<std::uint64_t>(chunk_.size()));
  put_bytes(bytes, chunk_);
  chunk.length = bytes.size();
  chunk_.clear();
  empty_ = true;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    auto& index = channels_[c].index;
    if (index.empty()) continue;
    const auto id = static_cast<std::uint16_t>(c + 1);
    std::vector<char> content;
    put_le(content, id);
    put_map(content, index);
    index.clear();
    chunk.indices.emplace_back(id, at_ + bytes.size());
    put_record(bytes, McapOp::message_index, content);
  }
  chunk.index_length = bytes.size() - chunk.length;
  chunks_.push_back(std::move(chunk));
  return put(bytes);
}

IoStatus McapWriter::flush() {
  if (IoStatus status = put_chunk(); !status.ok()) return status;
  return file_.flush();
}

void McapWriter::put_statistics(std::vector<char>& to) const {
  std::uint64_t messages = 0, begin = 0, end = 0;
  std::vector<std::pair<std::uint16_t, std::uint64_t>> counts;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    messages += channels_[c].sequence;
    if (channels_[c].written)
      counts.emplace_back(static_cast<std::uint16_t>(c + 1), std::uint64_t{channels_[c].sequence});
  }
  for (const Chunk& chunk : chunks_) {
    begin = begin == 0 ? chunk.begin_ns : std::min(begin, chunk.begin_ns);
    end = std::max(end, chunk.end_ns);
  }
  std::vector<char> content;
  put_le(content, messages);
  put_le(content, static_cast<std::uint16_t>(has_schema_ ? 1 : 0));
  put_le(content, static_cast<std::uint32_t>(counts.size()));
  put_le(content, std::uint64_t{0});  // attachments, metadata
  put_le(content, static_cast<std::uint32_t>(chunks_.size()));
  put_le(content, begin);
  put_le(content, end);
  put_map(content, counts);
  put_record(to, McapOp::statistics, content);
}

std::vector<char> McapWriter::summary() const {
  std::vector<char> bytes, offsets;
  const std::uint64_t start = at_;
  const auto group = [&](McapOp op, std::size_t from) {
    if (bytes.size() == from) return;
    std::vector<char> content;
    put_le(content, static_cast<std::uint8_t>(op));
    put_le(content, start + from);
    put_le(content, static_cast<std::uint64_t>(bytes.size() - from));
    put_record(offsets, McapOp::summary_offset, content);
  };
  if (has_schema_) put_bytes(bytes, schema_record());
  group(McapOp::schema, 0);
  std::size_t from = bytes.size();
  for (const Channel& channel : channels_) {
    if (channel.written) put_bytes(bytes, channel.record);
  }
  group(McapOp::channel, from);
  from = bytes.size();
  put_statistics(bytes);
  group(McapOp::statistics, from);
  from = bytes.size();
  for (const Chunk& chunk : chunks_) {
    std::vector<char> content;
    for (const std::uint64_t number : {chunk.begin_ns, chunk.end_ns, chunk.at, chunk.length}) {
      put_le(content, number);
    }
    put_map(content, chunk.indices);
    put_le(content, chunk.index_length);
    put_le_text(content, "");
    put_le(content, chunk.content);
    put_le(content, chunk.content);
    put_record(bytes, McapOp::chunk_index, content);
  }
  group(McapOp::chunk_index, from);

  const std::uint64_t offsets_at = start + bytes.size();
  put_bytes(bytes, offsets);
  put_le(bytes, static_cast<std::uint8_t>(McapOp::footer));
  put_le(bytes, std::uint64_t{8 + 8 + 4});
  put_le(bytes, start);
  put_le(bytes, offsets_at);
  put_le(bytes, crc32_of(bytes));
  put_bytes(bytes, kMcapMagic);
  return bytes;
}

IoStatus McapWriter::close() {
  IoStatus status = put_chunk();
  std::vector<char> end;
  put_le(end, static_cast<std::uint8_t>(McapOp::data_end));
  put_le(end, std::uint64_t{4});
  put_le(end, std::uint32_t{0});  // no check sum of all: each chunk has its own
  if (status.ok()) status = put(end);
  if (status.ok()) status = put(summary());
  IoStatus closed = file_.close();
  return status.ok() ? closed : status;
}

}  // namespace odas
