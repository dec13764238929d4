// SPDX-License-Identifier: MIT
#include "odas/pipeline/config.hpp"

#include <cmath>

namespace odas {

std::size_t lookback_hops(const PipelineConfig& config) {
  const double hop_ms = 1000.0 * config.general.size.hop_size / config.general.samplerate.mu;
  return static_cast<std::size_t>(std::lround(static_cast<double>(config.sss.lookback) / hop_ms));
}

std::size_t separation_frame(const PipelineConfig& config) {
  return static_cast<std::size_t>(config.general.size.frame_size) / 2 * 2;
}

double voice_delay_s(const PipelineConfig& config) {
  const SizeConfig& size = config.general.size;
  const int frame = size.frame_size / 2 * 2;  // as the pipeline takes it
  const auto samples =
      static_cast<double>(frame - size.hop_size) + static_cast<double>(lookback_hops(config)) * size.hop_size;
  return samples / config.general.samplerate.mu;
}

}  // namespace odas
