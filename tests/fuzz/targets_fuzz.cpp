// SPDX-License-Identifier: MIT
// Any bytes, in pieces of any size, as messages of targets: what is good can be followed, and after it all a
// good message is still understood.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "odas/base/contract.hpp"
#include "odas/io/target_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t piece = 1 + data[0];
  std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  odas::TargetReader reader;
  odas::TargetList targets;
  while (!text.empty()) {
    reader.push(text.substr(0, piece));
    text.remove_prefix(std::min(piece, text.size()));
    while (const auto message = reader.next()) {
      if (!message->is_good()) continue;
      std::size_t surplus = 0;
      targets = odas::heed(*message, targets, surplus);
      for (const odas::Target& target : targets.view()) ODAS_EXPECT(*odas::fault_of(target) == '\0');
    }
  }
  reader.reset();
  reader.push(R"({"targets":[{"tag":"door","x":1,"y":0,"z":0}]})");
  const auto good = reader.next();
  ODAS_EXPECT(good && good->is_good() && good->targets.view().size() == 1);
  return 0;
}
