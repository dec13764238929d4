// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "odas/studio/crc32.hpp"
#include "odas/studio/mcap.hpp"

namespace odas {

/// A message; the data hold until the next.
struct McapMessage {
  const McapChannel* channel = nullptr;
  std::uint64_t time = 0;  // UTC, ns
  std::span<const char> data;
};

/// Reads MCAP without compression from front to back, as far as it goes: a file that was cut off or damaged
/// gives what stands before that.
class McapReader {
 public:
  /// Throws IoError: no such file, or no MCAP.
  explicit McapReader(const std::filesystem::path& file);

  /// The next message in the order of the file; none: its end, or `fault`.
  [[nodiscard]] std::optional<McapMessage> next();
  /// "" while all is well: "was cut off", "is damaged".
  [[nodiscard]] const std::string& fault() const noexcept { return fault_; }
  /// "odas", where a Studio made it.
  [[nodiscard]] const std::string& profile() const noexcept { return profile_; }
  /// What the summary says; none: the file has no end. Does not move the reader.
  [[nodiscard]] std::optional<McapStatistics> statistics();
  /// The channels of the summary, where there is one.
  [[nodiscard]] std::vector<McapChannel> summary_channels();

 private:
  /// The next record of the data section, within a chunk or not.
  [[nodiscard]] std::optional<McapOp> read_record();
  [[nodiscard]] bool read(std::size_t bytes, std::vector<char>& to);
  [[nodiscard]] bool enter_chunk(std::uint64_t length);
  void check_chunk();
  template <class Take>
  void read_summary(Take take);

  std::ifstream file_;
  std::uint64_t size_ = 0, at_ = 0;
  std::string fault_, profile_;
  std::vector<char> record_;
  std::map<std::uint16_t, McapChannel> channels_;
  std::uint64_t chunk_end_ = 0;
  std::uint32_t chunk_sum_ = 0;  // as it should be; 0: not known
  Crc32 sum_;
};

}  // namespace odas
