// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "odas/engine/config.hpp"
#include "odas/engine/run.hpp"
#include "odas/io/report_sink.hpp"

namespace odas {

/// The first microphone, beside the voices.
inline constexpr const char* kReferenceFile = "microphone_1.wav";

/// What `odas run` knows of a run that is over.
struct RunFacts {
  std::string recording, config_file;  // as the user wrote them
  std::size_t channels = 0;
  int sample_rate = 0;      // of the recording
  bool reference = false;   // kReferenceFile was written
  double work_seconds = 0;  // by the clock on the wall
  std::vector<std::string> warnings;
};

/// `report.html` in the folder of the run. Throws IoError.
void write_run_report(const std::filesystem::path& folder, const RunFacts& facts, const RunSummary& summary,
                      const PipelineConfig& config, const ReportSink& sink);

/// "66 times faster than real time", "2.1 times slower than real time"
[[nodiscard]] std::string speed_text(double sound_seconds, double work_seconds);

}  // namespace odas
