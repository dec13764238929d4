// SPDX-License-Identifier: MIT
// Any bytes, in chunks of any size, as the raw stream of a socket: frames come out whole, no more than fit,
// and another stream is understood after it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "odas/base/contract.hpp"
#include "odas/io/pcm_assembler.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const std::size_t channels = 1 + data[0] % 9;
  const std::size_t chunk = 1 + data[1];
  odas::PcmAssembler assembler(
      {static_cast<odas::SampleFormat>(data[2] % odas::kSampleFormats), channels, 16000}, 100);
  odas::Grid<float> block(channels, 1 + data[0] % 64);
  std::span<const char> bytes(reinterpret_cast<const char*>(data) + 3, size - 3);
  while (!bytes.empty()) {
    const std::size_t taken = assembler.push(bytes.first(std::min(chunk, bytes.size())));
    bytes = bytes.subspan(taken);
    if (!assembler.fault().empty()) break;
    const std::size_t frames = assembler.pop(block);
    ODAS_EXPECT(frames <= block.cols());
    ODAS_EXPECT(taken > 0 || frames > 0);
  }
  while (assembler.pop(block) > 0) {}
  assembler.finish();
  ODAS_EXPECT(assembler.push(std::array<char, 400>{}) > 0);
  return 0;
}
