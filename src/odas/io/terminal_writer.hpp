// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "odas/io/byte_writer.hpp"
#include "odas/io/record_queue.hpp"

namespace odas {

/// Standard output: each record is sent at once. A recording waits for its reader, but looks at `stop`
/// meanwhile, so that a reader that has fallen asleep does not keep the program from ending. A live source
/// waits for nobody: a reader who falls far behind loses whole records.
class TerminalWriter : public ByteWriter {
 public:
  explicit TerminalWriter(const std::atomic<bool>* stop = nullptr, int descriptor = 1, bool waits = true)
      : stop_(stop), descriptor_(descriptor), waits_(waits) {}

  [[nodiscard]] std::string where() const override { return "standard output"; }
  IoStatus write(std::span<const char> record) override;
  IoStatus flush() override { return send(0); }
  IoStatus close() override;
  [[nodiscard]] std::uint64_t lost_records() const noexcept override { return lost_; }

 private:
  /// Sends what waits, as long as the reader takes something every `patience_ms`.
  IoStatus send(int patience_ms);
  [[nodiscard]] bool stopped() const noexcept;

  const std::atomic<bool>* stop_;
  int descriptor_;
  bool waits_;
  RecordQueue queue_;
  std::uint64_t lost_ = 0;
};

}  // namespace odas
