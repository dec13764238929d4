// SPDX-License-Identifier: MIT
// Any bytes as a configuration: faults are found and said, and what has none can be checked and described.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "odas/base/contract.hpp"
#include "odas/config/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const odas::LoadedConfiguration loaded = odas::read_configuration_text(text, "fuzz.cfg");
  for (const odas::Fault& fault : loaded.faults) ODAS_EXPECT(!odas::to_string(fault).empty());
  return 0;
}
