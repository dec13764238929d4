// SPDX-License-Identifier: MIT
// report.html: a whole run in one file that opens from disk in any browser and loads nothing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "odas/io/report_history.hpp"

namespace odas {

/// A WAV file that the report plays.
struct ReportClip {
  std::string file;    // relative to the report, with forward slashes
  double start_s = 0;  // where its first sample lies in the recording
};

struct ReportSource {
  SourceHistory history;
  std::optional<ReportClip> voice;
};

/// All that the page shows. Text may hold anything: it is escaped.
struct ReportData {
  std::string title;  // name of the recording
  double seconds = 0;
  std::vector<Vec3> mics;  // m
  std::vector<ReportSource> sources;
  std::vector<PotentialPoint> potentials;
  std::optional<ReportClip> reference;                     // the first microphone
  std::vector<std::pair<std::string, std::string>> facts;  // name, value; in order
  std::vector<std::string> warnings;
};

/// More sound than this (in bytes of WAV) is not carried inside the page: it links to the files beside it.
inline constexpr std::uintmax_t kMaxEmbeddedAudio = 30'000'000;

/// Writes the page whole or not at all; the clips are read relative to its folder. Throws IoError.
void write_report(const std::filesystem::path& file, const ReportData& data,
                  std::uintmax_t max_embedded_audio = kMaxEmbeddedAudio);

}  // namespace odas
