// SPDX-License-Identifier: MIT
#include "odas/io/report_audio.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>

#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas {

Waveform waveform_of(const std::filesystem::path& file, std::size_t columns) {
  SndfileHandle sound(file.string());
  if (sound.error() != 0 || sound.channels() != 1) {
    throw IoError("cannot read " + file.string() + " back: " + sound.strError());
  }
  const auto frames = static_cast<std::size_t>(sound.frames());
  Waveform result;
  result.seconds = static_cast<double>(frames) / sound.samplerate();
  result.peaks.resize(std::min(columns, frames));

  std::array<float, 4096> block{};
  std::size_t at = 0;
  for (sf_count_t n = 0; (n = sound.readf(block.data(), block.size())) > 0;) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n) && at < frames; ++i, ++at) {
      float& peak = result.peaks[at * result.peaks.size() / frames];
      peak = std::max(peak, std::abs(block[i]));
    }
  }
  for (const float peak : result.peaks) result.peak = std::max(result.peak, peak);
  return result;
}

void write_base64(std::ostream& out, const std::filesystem::path& file) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::ifstream in(file, std::ios::binary);
  std::array<char, std::size_t{3} * 4096> block{};
  std::string text;
  // All blocks but the last are whole multiples of three bytes, so only the end is padded.
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    const auto size = static_cast<std::size_t>(in.gcount());
    text.clear();
    for (std::size_t i = 0; i < size; i += 3) {
      const auto byte = [&](std::size_t k) -> unsigned {
        return i + k < size ? static_cast<unsigned char>(block[i + k]) : 0U;
      };
      const unsigned bits = byte(0) << 16 | byte(1) << 8 | byte(2);
      text += kDigits[bits >> 18];
      text += kDigits[bits >> 12 & 63U];
      text += i + 1 < size ? kDigits[bits >> 6 & 63U] : '=';
      text += i + 2 < size ? kDigits[bits & 63U] : '=';
    }
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
  }
  if (!in.eof()) throw IoError("cannot read " + file.string() + " back");
}

}  // namespace odas
