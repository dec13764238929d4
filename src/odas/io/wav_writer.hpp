// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "odas/io/file_writer.hpp"

namespace odas {

/// A WAV file of interleaved PCM (8 bits unsigned, as the format has it). Its header is right after each
/// flush, so that the file is valid whenever the program ends. Beyond 4 GiB it is RF64.
class WavWriter : public ByteWriter {
 public:
  struct Format {
    int sample_rate = 16000;
    std::size_t channels = 1;
    int bits = 16;
  };

  /// Replaces the file. Throws IoError.
  WavWriter(std::filesystem::path file, Format format);

  [[nodiscard]] std::string where() const override { return file_.where(); }
  IoStatus write(std::span<const char> record) override { return file_.write(record); }
  IoStatus flush() override;
  IoStatus close() override;

 private:
  IoStatus update_header();

  FileWriter file_;
  Format format_;
};

inline constexpr std::size_t kWavHeaderSize = 80;
using WavHeaderBytes = std::array<char, kWavHeaderSize>;

/// The header of a file of `size` bytes in all: RIFF with room for the long sizes of RF64, or RF64.
/// Source: EBU Tech 3306.
[[nodiscard]] WavHeaderBytes wav_header(const WavWriter::Format& format, std::uint64_t size);

}  // namespace odas
