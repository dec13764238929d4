// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "odas/io/byte_writer.hpp"

namespace odas {

/// Standard output: each record is sent at once. While a reader makes it wait, it looks at `stop`, so that a
/// reader that has fallen asleep does not keep the program from ending.
class TerminalWriter : public ByteWriter {
 public:
  explicit TerminalWriter(const std::atomic<bool>* stop = nullptr, int descriptor = 1)
      : stop_(stop), descriptor_(descriptor) {}

  [[nodiscard]] std::string where() const override { return "standard output"; }
  IoStatus write(std::span<const char> record) override;
  IoStatus flush() override { return {}; }
  IoStatus close() override { return {}; }

 private:
  const std::atomic<bool>* stop_;
  int descriptor_;
  bool gave_up_ = false;
};

}  // namespace odas
