// SPDX-License-Identifier: MIT
#include "odas/engine/hop_loop.hpp"

namespace odas {

HopLoop::HopLoop(const Configuration& config, std::size_t channels, int source_rate, Pipeline& pipeline,
                 TargetInbox* targets)
    : front_end_(config, channels, source_rate),
      pipeline_(pipeline),
      targets_(targets),
      hop_(pipeline.mics(), pipeline.hop_size()) {
  ODAS_EXPECT(front_end_.mics() == pipeline.mics());
}

Metrics HopLoop::metrics() const noexcept {
  Metrics metrics;
  metrics.hops = hops_;
  metrics.hop_time = hop_time_;
  metrics.sound_seconds = static_cast<double>(hops_) * static_cast<double>(pipeline_.hop_size()) /
                          static_cast<double>(pipeline_.sample_rate());
  metrics.non_finite_samples = front_end_.non_finite_samples() + pipeline_.non_finite_samples();
  return metrics;
}

}  // namespace odas
