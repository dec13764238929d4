// SPDX-License-Identifier: MIT
#include "odas/engine/run_report.hpp"

namespace odas {

HealthWatch::HealthWatch(InputHealth& health, int sample_rate, BlockFeed& feed)
    : health_(health), feed_(feed), period_(static_cast<std::size_t>(sample_rate) / 4) {}

void HealthWatch::passed(std::size_t frames) {
  passed_ += frames;
  if (passed_ < period_) return;
  passed_ = 0;
  for (std::string& warning : health_.take_warnings()) feed_.warn(std::move(warning));
}

void finish_summary(RunSummary& summary, HopLoop& loop, const SinkGroup& sinks, BlockFeed& feed) {
  const Metrics lost = summary.metrics;  // dropped hops and overruns: known to the run alone
  summary.metrics = loop.metrics();
  summary.metrics.dropped_hops = lost.dropped_hops;
  summary.metrics.overruns = lost.overruns;
  summary.metrics.lost_frames = lost.lost_frames;
  feed.finish();
  for (std::string& warning : loop.health().take_warnings()) feed.warn(std::move(warning));
  const auto warn = [&](std::uint64_t count, const char* what) {
    if (count > 0) feed.warn(std::to_string(count) + what);
  };
  warn(summary.metrics.non_finite_samples,
       " samples of the input were not numbers (NaN or infinite) and were taken as silence");
  warn(summary.metrics.overruns, " blocks of the source were lost: the engine was too slow for it");
  warn(summary.metrics.lost_frames, " frames of the source were lost; the time stamps count them");
  warn(summary.metrics.dropped_hops, " hops were dropped: an output was too slow");
  sinks.report(summary, [&](std::string warning) { feed.warn(std::move(warning)); });
}

}  // namespace odas
