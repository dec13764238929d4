// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "odas/engine/config.hpp"
#include "odas/engine/sink.hpp"
#include "odas/io/report_history.hpp"
#include "odas/io/voice_recorder.hpp"

namespace odas {

/// Gathers a run for its report, and writes the voices: `voices/source_3.wav`, ..., `voices/index.json`.
class ReportSink final : public Sink {
 public:
  /// `folder` is the folder of the run. Throws IoError.
  ReportSink(const std::filesystem::path& folder, const PipelineConfig& config);

  [[nodiscard]] std::string name() const override { return "voices"; }
  [[nodiscard]] Wanted wanted() const noexcept override { return {true, true, true, false}; }
  IoStatus write(const HopResult& hop) override;
  IoStatus flush() override { return recorder_.flush(); }
  IoStatus close() override;
  [[nodiscard]] std::uint64_t clipped_samples() const noexcept override {
    return recorder_.clipped_samples();
  }

  [[nodiscard]] const ReportHistory& history() const noexcept { return history_; }
  [[nodiscard]] const std::vector<Voice>& voices() const noexcept { return recorder_.voices(); }

 private:
  std::filesystem::path folder_;
  ReportHistory history_;
  VoiceRecorder recorder_;
};

}  // namespace odas
