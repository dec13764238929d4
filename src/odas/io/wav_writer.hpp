// SPDX-License-Identifier: MIT
#pragma once

#include "odas/io/file_writer.hpp"

namespace odas {

/// A WAV file of interleaved PCM (8 bits unsigned, as the format has it). Its header is right after each
/// flush, so that the file is valid whenever the program ends. Beyond 4 GiB the header says "to the end of
/// the file".
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

}  // namespace odas
