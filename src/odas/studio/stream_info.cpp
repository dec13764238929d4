// SPDX-License-Identifier: MIT
#include "odas/studio/stream_info.hpp"

#include <filesystem>

namespace odas {

StreamInfo stream_info(const CheckedDocument& checked) {
  const Configuration& config = checked.config;
  const PipelineConfig& pipeline = config.pipeline;
  StreamInfo info;
  info.name = checked.document.name;
  info.source = source_text(config.raw);
  info.config_text = checked.document.text;
  info.config_hash = hash_of(checked.document.text);
  info.sample_rate = pipeline.general.samplerate.mu;
  info.hop_size = static_cast<std::size_t>(pipeline.general.size.hop_size);
  info.slots = pipeline.sst.slots();
  info.potentials = static_cast<std::size_t>(pipeline.ssl.n_pots);
  info.lookback_s =
      static_cast<double>(lookback_hops(pipeline) * info.hop_size) / static_cast<double>(info.sample_rate);
  info.voice_delay_s = voice_delay_s(pipeline);
  info.separated_gain = pipeline.sss.gain_sep;
  info.postfiltered_gain = pipeline.sss.gain_pf;
  info.mics = pipeline.general.mics;
  for (std::size_t m = 0; m < info.mics.size(); ++m) {
    const std::vector<int>& map = config.mapping.map;
    info.channels.push_back(m < map.size() ? map[m] : map.empty() ? static_cast<int>(m) + 1 : 0);
  }
  return info;
}

std::string source_text(const RawConfig& raw) {
  const InterfaceConfig& from = raw.interface;
  if (from.type == "file") return std::filesystem::path(from.path).filename().string();
  if (from.type == "soundcard") {
    return "hw:" + std::to_string(from.card) + "," + std::to_string(from.device);
  }
  if (from.type == "soundcard_name") return from.devicename;
  if (from.type == "pulseaudio") return from.source;
  if (from.type == "socket" || from.type == "socket_listen") {
    return (from.ip.empty() ? "127.0.0.1" : from.ip) + ":" + std::to_string(from.port);
  }
  return from.type;
}

}  // namespace odas
