// SPDX-License-Identifier: MIT
#include "odas/pipeline/config.hpp"

#include <cmath>

namespace odas {

std::size_t lookback_hops(const PipelineConfig& config) {
  const double hop_ms = 1000.0 * config.general.size.hop_size / config.general.samplerate.mu;
  return static_cast<std::size_t>(std::lround(static_cast<double>(config.sss.lookback) / hop_ms));
}

std::size_t separation_frame(const PipelineConfig& config) {
  const int frame = config.sss.frame_size > 0 ? config.sss.frame_size : config.general.size.frame_size;
  return static_cast<std::size_t>(frame) / 2 * 2;
}

double voice_delay_s(const PipelineConfig& config) {
  const SizeConfig& size = config.general.size;
  const auto hop = static_cast<double>(size.hop_size);
  const double samples =
      static_cast<double>(separation_frame(config)) - hop + static_cast<double>(lookback_hops(config)) * hop;
  return samples / config.general.samplerate.mu;
}

}  // namespace odas
