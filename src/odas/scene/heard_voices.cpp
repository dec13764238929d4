// SPDX-License-Identifier: MIT
#include "odas/scene/heard_voices.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/scene/sound.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Voice {
  long first = 0;  // sample of the recording
  std::vector<float> sound;
};

std::vector<char> bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw IoError("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Never fewer than the tracks show; a system may end some hops of sound early.
std::size_t channels_of(std::size_t samples, const RawLayout& layout) {
  const double per_channel = static_cast<double>(layout.hops * layout.hop_size);
  const auto channels =
      per_channel > 0 ? static_cast<std::size_t>(std::lround(static_cast<double>(samples) / per_channel)) : 0;
  return std::max({channels, layout.slots, std::size_t{1}});
}

}  // namespace

VoiceOf raw_voices(const fs::path& file, const RawLayout& layout) {
  const auto bytes = std::make_shared<const std::vector<char>>(bytes_of(file));
  if (bytes->empty()) return {};
  const std::size_t channels = channels_of(bytes->size() / 2, layout);
  return [bytes, channels, hop_size = layout.hop_size](std::size_t hop, const HeardTrack& track,
                                                       std::span<float> out) {
    std::ranges::fill(out, 0.F);
    if (track.slot >= channels || (hop + 1) * hop_size * channels * 2 > bytes->size()) return;
    for (std::size_t n = 0; n < out.size(); ++n) {
      const std::size_t at = 2 * ((hop * hop_size + n) * channels + track.slot);
      const auto low = static_cast<unsigned char>((*bytes)[at]);
      const auto high = static_cast<unsigned char>((*bytes)[at + 1]);
      const auto value = static_cast<std::int16_t>(static_cast<std::uint16_t>(low | high << 8U));
      out[n] = static_cast<float>(value) / 32768.F;
    }
  };
}

VoiceOf voices_by_id(const fs::path& folder, const KnownScene& scene) {
  const auto voices = std::make_shared<std::map<std::uint64_t, Voice>>();
  const fs::path index = folder / "index.json";
  try {
    for (const json& entry : json::parse(bytes_of(index))) {
      const double first = std::round(entry.at("start").get<double>() * scene.sample_rate);
      (*voices)[entry.at("id").get<std::uint64_t>()] = {
          static_cast<long>(first),
          read_mono(folder / entry.at("file").get<std::string>(), scene.sample_rate)};
    }
  } catch (const json::exception& error) {
    throw IoError(index.string() + " does not say which voices there are: " + error.what());
  }
  if (voices->empty()) return {};
  return [voices, hop_size = scene.hop_size](std::size_t hop, const HeardTrack& track, std::span<float> out) {
    std::ranges::fill(out, 0.F);
    const auto voice = voices->find(track.id);
    if (voice == voices->end()) return;
    for (std::size_t n = 0; n < out.size(); ++n) {
      const long at = static_cast<long>(hop * hop_size + n) - voice->second.first;
      if (at >= 0 && at < static_cast<long>(voice->second.sound.size())) {
        out[n] = voice->second.sound[static_cast<std::size_t>(at)];
      }
    }
  };
}

}  // namespace odas
