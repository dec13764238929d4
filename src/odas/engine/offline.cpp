// SPDX-License-Identifier: MIT
#include "odas/engine/offline.hpp"

#include "odas/engine/block_feed.hpp"
#include "odas/engine/denormals.hpp"
#include "odas/engine/hop_loop.hpp"
#include "odas/engine/run_report.hpp"
#include "odas/engine/sink_group.hpp"

namespace odas {

RunSummary run_offline(AudioSource& source, const Configuration& config, Pipeline& pipeline,
                       std::span<Sink* const> sinks, const RunOptions& options) {
  const FlushDenormals flush_denormals;
  RunSummary summary;
  HopLoop loop(config, source.channels(), source.sample_rate(), pipeline, options.targets, options.pipelines);
  BlockFeed feed(source, options, summary);
  SinkGroup group(sinks);
  HealthWatch watch(loop.health(), source.sample_rate(), feed);

  const auto write = [&](const HopResult& hop) { group.write_all(hop); };
  Grid<float> block(source.channels(), static_cast<std::size_t>(config.raw.hop_size));
  while (const auto fed = feed.next(block, group.failed())) {
    if (fed->lost > 0) loop.skip(fed->lost, write);
    loop.push(GridView<const float>(block.data(), block.rows(), fed->frames, block.cols()), write);
    group.flush_in_time();
    watch.passed(fed->frames);
  }
  loop.finish(options.pad_last_block, write);
  group.close();
  finish_summary(summary, loop, group, feed);
  return summary;
}

}  // namespace odas
