// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "odas/array/types.hpp"

namespace odas {

enum class StreamKind { tracks, potentials, categories };

/// What a stream of text says of one hop: an object of `json` or of `jsonl`, of ODAS or of odas.
struct StreamRecord {
  StreamKind kind = StreamKind::tracks;
  HopIndex time = 0;
  std::vector<Track> tracks;          // [slot]; empty slots have id 0. Of categories: the category alone
  std::vector<Potential> potentials;  // in their order
  bool is_line = false;               // of jsonl: it has its own times, and stands on one line
  std::string fault;                  // "" if it is good; one line

  [[nodiscard]] bool is_good() const noexcept { return fault.empty(); }
};

/// Reads one object. Its rows say what kind it is; one without rows is taken as `expected`. ODAS's `nan` is
/// read as 0. Faults: no JSON, no `timeStamp` or `src`, rows that are none of the kinds.
[[nodiscard]] StreamRecord read_stream_record(std::string_view json, StreamKind expected);

}  // namespace odas
