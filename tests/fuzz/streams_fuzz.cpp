// SPDX-License-Identifier: MIT
// Any bytes, in chunks of any size, as what a sender of odasserver says.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "odas/base/contract.hpp"
#include "odas/io/stream_intake.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t chunk = 1 + data[0];
  std::size_t said = 0;
  odas::TextIntake intake(
      odas::StreamKind::tracks,
      [](const odas::StreamRecord&, std::string_view text) {
        ODAS_EXPECT(!text.empty());
        return odas::IoStatus();
      },
      [&](const std::string& what) {
        ODAS_EXPECT(what.size() < 4096);
        ++said;
      });
  std::span<const char> bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min(chunk, bytes.size()));
    ODAS_EXPECT(intake.take(piece).ok());
    bytes = bytes.subspan(piece.size());
  }
  ODAS_EXPECT(intake.close().ok());
  ODAS_EXPECT(said <= 2);
  return 0;
}
