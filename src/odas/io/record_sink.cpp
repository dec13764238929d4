// SPDX-License-Identifier: MIT
#include "odas/io/record_sink.hpp"

#include <utility>

namespace odas {

RecordSink::RecordSink(std::string stream, std::unique_ptr<HopEncoder> encoder,
                       std::unique_ptr<ByteWriter> writer)
    : stream_(std::move(stream)), encoder_(std::move(encoder)), writer_(std::move(writer)) {}

std::string RecordSink::name() const { return stream_ + " (" + writer_->where() + ")"; }

}  // namespace odas
