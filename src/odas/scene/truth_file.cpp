// SPDX-License-Identifier: MIT
#include "odas/scene/truth_file.hpp"

#include <fstream>

#include <nlohmann/json.hpp>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path truth_file_of(const fs::path& folder_or_file) {
  return fs::is_directory(folder_or_file) ? folder_or_file / "truth.json" : folder_or_file;
}

KnownSource source_of(const json& entry, std::size_t hops) {
  KnownSource source;
  for (const json& d : entry.at("doa")) {
    source.direction.push_back({d.at(0).get<double>(), d.at(1).get<double>(), d.at(2).get<double>()});
  }
  for (const json& active : entry.at("active")) {
    source.active.push_back((active.is_boolean() ? active.get<bool>() : active.get<int>() != 0) ? 1 : 0);
  }
  if (source.direction.size() != hops || source.active.size() != hops) {
    throw IoError("a source has " + std::to_string(source.direction.size()) + " directions and " +
                  std::to_string(source.active.size()) + " times active, where there are " +
                  std::to_string(hops) + " hops");
  }
  return source;
}

KnownScene scene_of(const json& truth) {
  KnownScene scene;
  scene.sample_rate = truth.at("fs").get<int>();
  scene.hop_size = truth.at("hop").get<std::size_t>();
  const double seconds = truth.at("scene").at("seconds").get<double>();
  if (scene.sample_rate <= 0 || scene.hop_size == 0 || !(seconds > 0)) {
    throw IoError("fs, hop and scene.seconds must be over 0");
  }
  scene.hops = static_cast<std::size_t>(seconds / scene.hop_seconds());
  for (const json& source : truth.at("sources")) scene.sources.push_back(source_of(source, scene.hops));
  return scene;
}

/// The first channel of a sound file.
std::vector<float> first_channel(const fs::path& file, int sample_rate) {
  SndfileHandle sound(file.string());
  if (sound.error() != 0) throw IoError("cannot read " + file.string() + ": " + sound.strError());
  if (sound.samplerate() != sample_rate) {
    throw IoError(file.string() + " has " + std::to_string(sound.samplerate()) + " Hz, the truth " +
                  std::to_string(sample_rate) + " Hz");
  }
  const auto channels = static_cast<std::size_t>(sound.channels());
  std::vector<float> all(static_cast<std::size_t>(sound.frames()) * channels);
  sound.readf(all.data(), sound.frames());
  std::vector<float> first(static_cast<std::size_t>(sound.frames()));
  for (std::size_t n = 0; n < first.size(); ++n) first[n] = all[n * channels];
  return first;
}

}  // namespace

KnownScene read_truth(const fs::path& folder_or_file) {
  const fs::path file = truth_file_of(folder_or_file);
  std::ifstream in(file, std::ios::binary);
  if (!in) throw IoError("cannot read the truth of a scene: there is no " + file.string());
  try {
    return scene_of(json::parse(in));
  } catch (const json::exception& error) {
    throw IoError(file.string() + " is not the truth of a scene: " + error.what());
  } catch (const IoError& error) {
    throw IoError(file.string() + " is not the truth of a scene: " + error.what());
  }
}

std::optional<KnownSound> read_known_sound(const fs::path& folder_or_file, const KnownScene& scene) {
  const fs::path folder = truth_file_of(folder_or_file).parent_path();
  const fs::path wav = folder / "mics.wav";
  const fs::path flac = folder / "mics.flac";
  const fs::path mics = fs::exists(wav) ? wav : flac;
  if (!fs::exists(mics) || scene.sources.empty()) return std::nullopt;
  KnownSound sound;
  sound.mic = first_channel(mics, scene.sample_rate);
  for (std::size_t k = 0; k < scene.sources.size(); ++k) {
    sound.images.push_back(
        first_channel(folder / ("image_" + std::to_string(k) + ".wav"), scene.sample_rate));
  }
  return sound;
}

}  // namespace odas
