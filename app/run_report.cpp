// SPDX-License-Identifier: MIT
#include "run_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "odas/io/report.hpp"

namespace odas {
namespace {

Vec3 position(const MicConfig& mic) { return {mic.mu[0], mic.mu[1], mic.mu[2]}; }

std::string array_text(const std::vector<MicConfig>& mics) {
  float aperture = 0;
  for (const MicConfig& a : mics) {
    for (const MicConfig& b : mics) aperture = std::max(aperture, norm(position(a) - position(b)));
  }
  return fmt::format("{} microphones, {:.0f} mm across", mics.size(), 1000 * aperture);
}

}  // namespace

std::string speed_text(double sound_seconds, double work_seconds) {
  if (sound_seconds <= 0 || work_seconds <= 0) return "no sound";
  const double times = sound_seconds / work_seconds;
  return times >= 1 ? fmt::format("{:.{}f} times faster than real time", times, times < 10 ? 1 : 0)
                    : fmt::format("{:.1f} times slower than real time", 1 / times);
}

void write_run_report(const std::filesystem::path& folder, const RunFacts& facts, const RunSummary& summary,
                      const PipelineConfig& config, const ReportSink& sink) {
  const double seconds = static_cast<double>(summary.frames) / facts.sample_rate;
  ReportData data;
  data.title = std::filesystem::path(facts.recording).filename().string();
  data.seconds = seconds;
  for (const MicConfig& mic : config.general.mics) data.mics.push_back(position(mic));
  for (SourceHistory& history : sink.history().sources()) {
    ReportSource source{std::move(history), std::nullopt};
    const auto voice = std::find_if(sink.voices().begin(), sink.voices().end(),
                                    [&](const Voice& v) { return v.id == source.history.id; });
    if (voice != sink.voices().end()) source.voice = ReportClip{"voices/" + voice->file, voice->start_s};
    data.sources.push_back(std::move(source));
  }
  data.potentials = sink.history().potentials();
  if (facts.reference) data.reference = ReportClip{kReferenceFile, 0};
  data.facts = {
      {"Recording", facts.recording},
      {"Sound", fmt::format("{:.1f} s, {} channels, {} Hz", seconds, facts.channels, facts.sample_rate)},
      {"Array", array_text(config.general.mics)},
      {"Configuration", facts.config_file},
      {"Method", fmt::format("localization {}, tracking {}, separation {}", config.ssl.mode, config.sst.mode,
                             config.sss.mode_sep)},
      {"Work", fmt::format("{:.2f} s, {}", facts.work_seconds, speed_text(seconds, facts.work_seconds))},
  };
  if (summary.end == RunSummary::End::stopped)
    data.facts.emplace_back("End", "stopped before the recording ended");
  data.warnings = facts.warnings;
  write_report(folder / "report.html", data);
}

}  // namespace odas
