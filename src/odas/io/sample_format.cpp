// SPDX-License-Identifier: MIT
#include "odas/io/sample_format.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "odas/io/pcm.hpp"

namespace odas {
namespace {

struct Row {
  SampleFormat format;
  std::string_view name;
  std::size_t bytes;
  int bits;
};
constexpr std::array<Row, kSampleFormats> kRows{{
    {SampleFormat::s32, "S32_LE", 4, 32},
    {SampleFormat::s24_3, "S24_3LE", 3, 24},
    {SampleFormat::s24, "S24_LE", 4, 24},
    {SampleFormat::f32, "FLOAT_LE", 4, 32},
    {SampleFormat::s16, "S16_LE", 2, 16},
    {SampleFormat::s8, "S8", 1, 8},
    {SampleFormat::u8, "U8", 1, 8},
}};

const Row& row_of(SampleFormat format) noexcept { return kRows[static_cast<std::size_t>(format)]; }

/// `load(from)` is a sample as float.
template <std::size_t Size, class Load>
void decode(const char* bytes, GridView<float> block, Load load) noexcept {
  const std::size_t step = block.rows() * Size;
  for (std::size_t c = 0; c < block.rows(); ++c) {
    const char* from = bytes + c * Size;
    for (float& x : block[c]) {
      x = load(from);
      from += step;
    }
  }
}

}  // namespace

std::string_view name_of(SampleFormat format) noexcept { return row_of(format).name; }
std::size_t bytes_of(SampleFormat format) noexcept { return row_of(format).bytes; }
int bits_of(SampleFormat format) noexcept { return row_of(format).bits; }

std::optional<SampleFormat> sample_format(std::string_view name) noexcept {
  const auto* row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return r.name == name; });
  return row == kRows.end() ? std::nullopt : std::optional(row->format);
}

SampleFormat stream_format(const RawConfig& raw) noexcept {
  if (const auto named = sample_format(raw.format)) return *named;
  if (raw.n_bits == 8) return SampleFormat::s8;
  if (raw.n_bits == 24) return SampleFormat::s24_3;
  return raw.n_bits == 32 ? SampleFormat::s32 : SampleFormat::s16;
}

void decode_samples(std::span<const char> bytes, SampleFormat format, GridView<float> block) noexcept {
  ODAS_EXPECT(bytes.size() == block.rows() * block.cols() * bytes_of(format));
  switch (format) {
    case SampleFormat::s24:
      // The fourth byte is whatever the driver left there.
      return decode<4>(bytes.data(), block, [](const char* from) {
        std::uint32_t value = 0;
        std::memcpy(&value, from, 3);
        return static_cast<float>(static_cast<std::int32_t>(value << 8) >> 8) / 8388608.0F;
      });
    case SampleFormat::f32:
      return decode<4>(bytes.data(), block, [](const char* from) {
        float value = 0;
        std::memcpy(&value, from, sizeof value);
        return value;
      });
    case SampleFormat::u8:
      return decode<1>(bytes.data(), block, [](const char* from) {
        return static_cast<float>(static_cast<int>(static_cast<unsigned char>(*from)) - 128) / 128.0F;
      });
    case SampleFormat::s8:
    case SampleFormat::s16:
    case SampleFormat::s24_3:
    case SampleFormat::s32:
      return decode_pcm(bytes, bits_of(format), block);
  }
}

}  // namespace odas
