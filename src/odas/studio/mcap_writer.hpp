// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "odas/io/file_writer.hpp"
#include "odas/studio/mcap.hpp"

namespace odas {

/// A file of MCAP without compression, with chunks, indices and a summary.
///
/// What was written before a `flush` is in the file as a whole chunk: whoever reads a file whose writer was
/// killed finds all of it. Errors: as of FileWriter; nothing is written after one.
class McapWriter {
 public:
  /// Replaces the file. Throws IoError.
  McapWriter(const std::filesystem::path& file, std::string_view library);

  /// A channel by its topic; JSON channels get the schema "any object".
  std::uint16_t add_channel(const McapChannel& channel);
  /// `time`: UTC, ns.
  IoStatus write(std::uint16_t channel, std::uint64_t time, std::span<const char> data);
  IoStatus flush();
  /// Finishes: the indices and the summary.
  IoStatus close();

  /// Bytes written, those that wait for the next flush too.
  [[nodiscard]] std::uint64_t size() const noexcept { return at_ + chunk_.size(); }
  [[nodiscard]] std::string where() const { return file_.where(); }

 private:
  struct Channel {
    std::vector<char> record;  // schema and channel, as they are written
    std::uint32_t sequence = 0;
    bool written = false;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> index;  // of this chunk: time, offset
  };
  struct Chunk {
    std::uint64_t begin_ns = 0, end_ns = 0;
    std::uint64_t at = 0, length = 0, index_length = 0, content = 0;
    std::vector<std::pair<std::uint16_t, std::uint64_t>> indices;  // channel, offset in the file
  };

  IoStatus put(std::span<const char> bytes);
  IoStatus put_chunk();
  [[nodiscard]] std::vector<char> summary() const;
  void put_statistics(std::vector<char>& to) const;

  FileWriter file_;
  std::uint64_t at_ = 0;  // bytes given to the file
  std::vector<Channel> channels_;
  std::vector<char> chunk_;  // records that wait
  Chunk waiting_;
  std::vector<Chunk> chunks_;
  bool empty_ = true;  // no message in this chunk
  bool has_schema_ = false;
};

}  // namespace odas
