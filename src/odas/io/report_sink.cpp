// SPDX-License-Identifier: MIT
#include "odas/io/report_sink.hpp"

#include "odas/base/error.hpp"

namespace odas {
namespace {

VoiceRecorder::Format format_of(const PipelineConfig& config) {
  const GeneralConfig& general = config.general;
  const double rate = general.samplerate.mu;
  return {general.samplerate.mu, general.size.hop_size / rate, voice_delay_s(config), config.sss.gain_sep};
}

}  // namespace

ReportSink::ReportSink(const std::filesystem::path& folder, const PipelineConfig& config)
    : folder_(folder / "voices"),
      history_(static_cast<std::size_t>(config.general.size.hop_size), config.general.samplerate.mu),
      recorder_(folder_, format_of(config)) {}

IoStatus ReportSink::write(const HopResult& hop) {
  history_.add(hop.time, hop.potentials, hop.tracks);
  return recorder_.add(hop.time, hop.tracks, hop.separated);
}

IoStatus ReportSink::close() {
  if (IoStatus status = recorder_.close(); !status.ok()) return status;
  try {
    write_voice_index(folder_ / "index.json", recorder_.voices(), history_.sources());
    return {};
  } catch (const IoError& error) { return IoStatus::failed(error.what()); }
}

}  // namespace odas
