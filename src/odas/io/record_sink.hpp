// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "odas/engine/sink.hpp"
#include "odas/io/byte_writer.hpp"
#include "odas/io/hop_encoder.hpp"

namespace odas {

/// A stream of text or numbers: one record a hop, encoded one way and written to one place.
class RecordSink : public Sink {
 public:
  /// `stream`: what the configuration calls it, "sst.tracked".
  RecordSink(std::string stream, std::unique_ptr<HopEncoder> encoder, std::unique_ptr<ByteWriter> writer);

  [[nodiscard]] std::string name() const override;
  [[nodiscard]] Wanted wanted() const noexcept override { return encoder_->wanted(); }
  IoStatus write(const HopResult& hop) override { return writer_->write(encoder_->encode(hop)); }
  IoStatus flush() override { return writer_->flush(); }
  IoStatus close() override { return writer_->close(); }
  [[nodiscard]] std::uint64_t lost_records() const noexcept override { return writer_->lost_records(); }

 private:
  std::string stream_;
  std::unique_ptr<HopEncoder> encoder_;
  std::unique_ptr<ByteWriter> writer_;
};

}  // namespace odas
