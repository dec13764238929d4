// SPDX-License-Identifier: MIT
#include "configured_run.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "odas/config/reader.hpp"
#include "odas/engine/live.hpp"
#include "odas/engine/offline.hpp"
#include "odas/io/registry.hpp"
#include "odas/io/run_equipment.hpp"

namespace odas {
namespace {

void tell(const std::string& program, const std::string& what) {
  std::fprintf(stderr, "%s: %s\n", program.c_str(), what.c_str());
}

}  // namespace

RunSummary run_configuration(const std::string& file, const ConfiguredRun& how, const std::string& program,
                             const std::atomic<bool>& stop) {
  const LoadedConfiguration loaded = load_configuration(file);
  for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", to_string(fault).c_str());
  const Configuration& config = loaded.config;
  try {
    // The sinks come last: nothing is overwritten for a run that cannot start.
    const std::unique_ptr<AudioSource> source = make_source(config.raw);
    Pipeline pipeline(config.pipeline);
    RunEquipment equipment(config, {.live = source->live(),
                                    .stop = &stop,
                                    .say = [&](const std::string& what) { tell(program, what); }});

    RunOptions options;
    options.silent_first_block = how.like_odas;
    options.pad_last_block = !how.like_odas;
    options.stop = &stop;
    options.targets = equipment.takes_targets() ? &equipment.targets() : nullptr;
    options.warn = [&](const std::string& warning) { tell(program, "warning: " + warning); };
    options.notice = [&](const std::string& notice) { tell(program, notice); };
    const auto run = how.threads ? run_live : run_offline;
    return run(*source, config, pipeline, equipment.sinks(), options);
  } catch (const ConfigError& error) { throw loaded.locations.locate(error); }
}

int say_end(const RunSummary& summary, const std::string& program) {
  if (summary.exit_code() != 0) tell(program, summary.fault);
  return summary.exit_code();
}

std::string describe(const Metrics& metrics) {
  const std::string echo =
      metrics.echo_return_loss_db != 0
          ? fmt::format("\nthe machine's own voice was lowered by {:.1f} dB", metrics.echo_return_loss_db)
          : "";
  const auto us = [](std::chrono::nanoseconds time) { return static_cast<double>(time.count()) / 1000; };
  return fmt::format(
             "{} hops, {:.2f} s of sound; a hop took {:.0f} us (median), {:.0f} us (p99), {:.0f} us "
             "(longest): "
             "{:.2f} % of real time\n"
             "{} hops dropped, {} lost by peers; {} blocks and {} frames of the source lost; {} samples "
             "clipped, {} "
             "not finite",
             metrics.hops, metrics.sound_seconds, us(metrics.hop_time.quantile(0.5)),
             us(metrics.hop_time.quantile(0.99)), us(metrics.hop_time.max()), 100 * metrics.real_time_share(),
             metrics.dropped_hops, metrics.lost_records, metrics.overruns, metrics.lost_frames,
             metrics.clipped_samples, metrics.non_finite_samples) +
         echo;
}

}  // namespace odas
