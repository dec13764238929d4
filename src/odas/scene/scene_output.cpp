// SPDX-License-Identifier: MIT
#include "odas/scene/scene_output.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>

#include <nlohmann/json.hpp>
#include <sndfile.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::size_t kMostChannelsOfFlac = 8;

std::int16_t to_pcm(float x) {
  return static_cast<std::int16_t>(std::lround(std::clamp(x * 32768.F, -32768.F, 32767.F)));
}

void write_sound(const std::filesystem::path& file, GridView<const float> sound, int sample_rate, int type) {
  SF_INFO info{};
  info.samplerate = sample_rate;
  info.channels = static_cast<int>(sound.rows());
  info.format = type | SF_FORMAT_PCM_16;
  std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> out(sf_open(file.c_str(), SFM_WRITE, &info), sf_close);
  if (!out) throw IoError("cannot write " + file.string() + ": " + sf_strerror(nullptr));
  double smallest = 1;  // as small as it goes; a setting that libsndfile wants before the first sample
  sf_command(out.get(), SFC_SET_COMPRESSION_LEVEL, &smallest, sizeof smallest);
  std::vector<std::int16_t> frames(sound.rows() * sound.cols());
  for (std::size_t m = 0; m < sound.rows(); ++m) {
    for (std::size_t n = 0; n < sound.cols(); ++n) frames[n * sound.rows() + m] = to_pcm(sound[m][n]);
  }
  const auto count = static_cast<sf_count_t>(sound.cols());
  const bool whole = sf_writef_short(out.get(), frames.data(), count) == count;
  if (sf_close(out.release()) != 0 || !whole) {
    throw IoError("cannot write all of " + file.string() + ": is the disk full?");
  }
}

double with_five_digits(float value) { return std::round(static_cast<double>(value) * 1e5) / 1e5; }

nlohmann::ordered_json truth_json(const Scene& scene, const SimulatedScene& result) {
  nlohmann::ordered_json truth;
  truth["fs"] = scene.sample_rate;
  truth["hop"] = scene.hop;
  truth["scene"] = {{"seconds", scene.seconds},
                    {"rt60", with_five_digits(scene.rt60)},
                    {"mics", scene.mics.size()},
                    {"seed", scene.seed}};
  if (scene.noise) truth["scene"]["snr"] = with_five_digits(scene.noise->snr_db);
  truth["sources"] = nlohmann::ordered_json::array();
  for (const SourceTruth& source : result.truth) {
    nlohmann::ordered_json doa = nlohmann::ordered_json::array();
    for (const Vec3 u : source.direction)
      doa.push_back({with_five_digits(u.x), with_five_digits(u.y), with_five_digits(u.z)});
    truth["sources"].push_back({{"name", source.name}, {"doa", doa}, {"active", source.active}});
  }
  return truth;
}

}  // namespace

void write_scene(const Scene& scene, const SimulatedScene& result, RecordingFormat format,
                 const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError("cannot make the folder " + folder.string() + ": " + error.message());
  const bool flac = format == RecordingFormat::flac &&
                    scene.mics.size() + (result.played.empty() ? 0 : 1) <= kMostChannelsOfFlac;
  // What the machine plays is one more channel: its reference.
  Grid<float> channels(result.mics.rows() + (result.played.empty() ? 0 : 1), result.mics.cols());
  for (std::size_t m = 0; m < channels.rows(); ++m) {
    const auto sound = m < result.mics.rows() ? result.mics[m] : std::span<const float>(result.played);
    std::copy(sound.begin(), sound.end(), channels[m].begin());
  }
  write_sound(folder / (flac ? "mics.flac" : "mics.wav"), channels, scene.sample_rate,
              flac ? SF_FORMAT_FLAC : SF_FORMAT_WAV);
  for (std::size_t k = 0; k < result.images.size(); ++k) {
    const GridView<const float> image(result.images[k].data(), 1, result.images[k].size());
    write_sound(folder / ("image_" + std::to_string(k) + ".wav"), image, scene.sample_rate, SF_FORMAT_WAV);
  }
  const std::filesystem::path file = folder / "truth.json";
  std::ofstream out(file);
  out << truth_json(scene, result).dump() << '\n';
  if (!out.flush()) throw IoError("cannot write all of " + file.string());
}

}  // namespace odas
