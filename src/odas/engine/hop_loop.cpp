// SPDX-License-Identifier: MIT
#include "odas/engine/hop_loop.hpp"

#include <algorithm>

namespace odas {

namespace {

std::uint64_t steady_ns() noexcept {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::nanoseconds(now).count());
}

/// Until nothing of the sound before a gap is left in frames, overlaps and filters.
std::uint64_t run_out_hops(const Configuration& config) {
  const SizeConfig& size = config.pipeline.general.size;
  const std::size_t frame =
      std::max(static_cast<std::size_t>(size.frame_size), separation_frame(config.pipeline));
  return frame / static_cast<std::size_t>(size.hop_size) + 2;
}

/// Until the last sound has come out: through the look-back, and the overlap of the frames. Without a
/// look-back there are as many results as hops went in, as ODAS has it.
std::size_t rest_hops(const Configuration& config, const Pipeline& pipeline) {
  const std::size_t late = pipeline.lookback_hops();
  return late == 0 ? 0 : late + (separation_frame(config.pipeline) - 1) / pipeline.hop_size();
}

}  // namespace

HopLoop::HopLoop(const Configuration& config, std::size_t channels, int source_rate, Pipeline& pipeline,
                 TargetInbox* targets, PipelineInbox* pipelines)
    : front_end_(config, channels, source_rate),
      gaps_(source_rate, pipeline.sample_rate(), pipeline.hop_size(),
            run_out_hops(config) + pipeline.lookback_hops()),
      silence_(channels, front_end_.block_size()),
      rest_(rest_hops(config, pipeline)),
      pipeline_(pipeline),
      targets_(targets),
      pipelines_(pipelines),
      hop_(pipeline.mics(), pipeline.hop_size()) {
  ODAS_EXPECT(front_end_.mics() == pipeline.mics());
  pipeline_.time_stages(&steady_ns);
}

Metrics HopLoop::metrics() const noexcept {
  Metrics metrics;
  metrics.hops = hops_;
  metrics.skipped_hops = skipped_hops_;
  metrics.hop_time = hop_time_;
  metrics.stage_times = pipeline_.stage_times();
  metrics.sound_seconds = static_cast<double>(hops_) * static_cast<double>(pipeline_.hop_size()) /
                          static_cast<double>(pipeline_.sample_rate());
  metrics.non_finite_samples = front_end_.non_finite_samples() + pipeline_.non_finite_samples();
  metrics.echo_return_loss_db = front_end_.echo_return_loss_db();
  return metrics;
}

}  // namespace odas
