// SPDX-License-Identifier: MIT
#include "odas/io/report_reference.hpp"

#include <cmath>

#include "odas/io/pcm.hpp"

namespace odas {
namespace {

constexpr int kBits = 16;

}  // namespace

ReferenceTap::ReferenceTap(AudioSource& source, std::size_t channel, const std::filesystem::path& file)
    : source_(source), channel_(channel), wav_(file, {source.sample_rate(), 1, kBits}) {}

ReadResult ReferenceTap::read(GridView<float> block) {
  ReadResult result = source_.read(block);
  if (result.frames == 0) return result;
  const auto heard = block[channel_].first(result.frames);
  finite_.assign(heard.begin(), heard.end());
  for (float& sample : finite_) {
    if (!std::isfinite(sample)) sample = 0;  // as the pipeline takes it
  }
  bytes_.resize(finite_.size() * pcm_bytes(kBits));
  encode_pcm(GridView<const float>(finite_.data(), 1, finite_.size()), 1, kBits, bytes_);
  if (IoStatus written = wav_.write(bytes_); !written.ok()) {
    result.end = true;
    result.status = std::move(written);
  }
  return result;
}

}  // namespace odas
