// SPDX-License-Identifier: MIT
#include "odas/io/report_reference.hpp"

#include <cmath>

#include "odas/base/error.hpp"

namespace odas {

ReferenceTap::ReferenceTap(AudioSource& source, std::size_t channel, const std::filesystem::path& file)
    : source_(source), channel_(channel), wav_(file, source.sample_rate()) {}

ReadResult ReferenceTap::read(GridView<float> block) {
  ReadResult result = source_.read(block);
  if (result.frames == 0) return result;
  const auto heard = block[channel_].first(result.frames);
  finite_.assign(heard.begin(), heard.end());
  for (float& sample : finite_) {
    if (!std::isfinite(sample)) sample = 0;  // as the pipeline takes it
  }
  try {
    wav_.write(finite_);
  } catch (const IoError& error) {
    result.end = true;
    result.status = IoStatus::failed(error.what());
  }
  return result;
}

}  // namespace odas
