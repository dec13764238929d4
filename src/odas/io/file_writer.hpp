// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "odas/io/byte_writer.hpp"
#include "odas/io/file_descriptor.hpp"

namespace odas {

/// A file, written in large pieces. When the disk is full it is cut back to its last whole record.
class FileWriter : public ByteWriter {
 public:
  /// Replaces the file. Throws IoError: no such folder, no permission, ...
  explicit FileWriter(std::filesystem::path file);

  [[nodiscard]] std::string where() const override { return file_.string(); }
  IoStatus write(std::span<const char> record) override;
  IoStatus flush() override;
  IoStatus close() override;

  /// Bytes of whole records that are in the file.
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }
  /// Writes over bytes that are there already: a header. Needs no room on the disk.
  IoStatus overwrite(std::uint64_t at, std::span<const char> bytes);

 private:
  IoStatus failed(int number);

  std::filesystem::path file_;
  FileDescriptor descriptor_;
  std::vector<char> buffer_;
  std::vector<std::size_t> ends_;  // of the records in the buffer
  std::uint64_t size_ = 0;
  bool well_ = true;
};

}  // namespace odas
