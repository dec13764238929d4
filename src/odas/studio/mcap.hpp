// SPDX-License-Identifier: MIT
// The parts of a file of MCAP. Source: https://mcap.dev/spec, version 0.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace odas {

inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

/// The first byte of a record; 8 bytes of length and the content follow.
enum class McapOp : std::uint8_t {
  header = 1,
  footer = 2,
  schema = 3,
  channel = 4,
  message = 5,
  chunk = 6,
  message_index = 7,
  chunk_index = 8,
  statistics = 11,
  summary_offset = 14,
  data_end = 15,
};
inline constexpr std::size_t kMcapRecordHead = 9;

struct McapChannel {
  std::string topic;
  std::string encoding;  // "json"; "odas": docs/protocol.md, binary messages
};

struct McapStatistics {
  std::uint64_t messages = 0;
  std::uint32_t channels = 0;
  std::uint32_t chunks = 0;
  std::uint64_t begin_ns = 0, end_ns = 0;
};

}  // namespace odas
