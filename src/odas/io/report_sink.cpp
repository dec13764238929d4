// SPDX-License-Identifier: MIT
#include "odas/io/report_sink.hpp"

#include <algorithm>

#include "odas/base/error.hpp"

namespace odas {
namespace {

VoiceRecorder::Format format_of(const GeneralConfig& general) {
  const double rate = general.samplerate.mu;
  return {general.samplerate.mu, general.size.hop_size / rate,
          (general.size.frame_size - general.size.hop_size) / rate};
}

bool too_loud(float sample) { return sample > 1 || sample < -1; }

}  // namespace

ReportSink::ReportSink(const std::filesystem::path& folder, const PipelineConfig& config)
    : folder_(folder / "voices"),
      gain_(config.sss.gain_sep),
      history_(static_cast<std::size_t>(config.general.size.hop_size), config.general.samplerate.mu),
      recorder_(folder_, format_of(config.general)) {}

IoStatus ReportSink::write(const HopResult& hop) {
  try {
    history_.add(hop.time, hop.potentials, hop.tracks);
    if (amplified_.rows() != hop.separated.rows()) {
      amplified_ = Grid<float>(hop.separated.rows(), hop.separated.cols());
    }
    for (std::size_t slot = 0; slot < hop.separated.rows(); ++slot) {
      const auto from = hop.separated[slot];
      const auto to = amplified_[slot];
      for (std::size_t i = 0; i < from.size(); ++i) to[i] = gain_ * from[i];
      if (hop.tracks[slot].id != 0)
        clipped_ += static_cast<std::uint64_t>(std::ranges::count_if(to, too_loud));
    }
    recorder_.add(hop.time, hop.tracks, amplified_);
    return {};
  } catch (const IoError& error) { return IoStatus::failed(error.what()); }
}

IoStatus ReportSink::close() {
  try {
    recorder_.close();
    write_voice_index(folder_ / "index.json", recorder_.voices(), history_.sources());
    return {};
  } catch (const IoError& error) { return IoStatus::failed(error.what()); }
}

}  // namespace odas
