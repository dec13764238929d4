// SPDX-License-Identifier: MIT
// Real (or measured) arrays: is somebody followed where the talker is, while he speaks?
#include <cmath>
#include <fstream>
#include <iostream>

#include "support/goldens.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.h>

namespace odas::recordings_test {
namespace {

struct Case {
  const char* name;
  const char* array;  // folder, and configuration of the test
  const char* file;
  std::vector<double> azimuths;  // degrees; empty: nobody speaks
  double tolerance;              // degrees
  double followed;               // least share of the hops with speech in which a track lies within tolerance
  double right;                  // least share of the tracks in those hops that lie within tolerance
  double error = 15;             // degrees; their mean deviation at most
};

/// The power of each hop of 8 ms, mean over five hops and all channels.
std::vector<double> hop_powers(const std::filesystem::path& file) {
  SF_INFO info{};
  SNDFILE* sound = sf_open(file.c_str(), SFM_READ, &info);
  if (sound == nullptr) throw std::runtime_error("cannot read " + file.string());
  const auto block = static_cast<std::size_t>(info.samplerate / 125 * info.channels);
  std::vector<float> samples(static_cast<std::size_t>(info.frames * info.channels));
  sf_read_float(sound, samples.data(), static_cast<sf_count_t>(samples.size()));
  sf_close(sound);
  std::vector<double> raw(samples.size() / block, 0.0);
  for (std::size_t h = 0; h < raw.size(); ++h) {
    for (std::size_t n = 0; n < block; ++n) {
      const auto x = static_cast<double>(samples[h * block + n]);
      raw[h] += x * x / static_cast<double>(block);
    }
  }
  std::vector<double> powers(raw.size(), 0.0);
  for (std::size_t h = 2; h + 2 < raw.size(); ++h) {
    for (std::size_t k = h - 2; k <= h + 2; ++k) powers[h] += raw[k] / 5;
  }
  return powers;
}

/// The hops in which somebody speaks: as the truth says, else those within 30 dB of the loudest.
std::vector<bool> speech(const std::filesystem::path& folder, const Case& c) {
  const std::vector<double> powers = hop_powers(folder / c.file);
  std::vector<bool> speaks(powers.size(), false);
  std::ifstream file(folder / "truth.json");
  const auto truth = nlohmann::json::parse(file);
  if (truth.contains("speech_samples_48k")) {
    const auto span = truth["speech_samples_48k"][std::filesystem::path(c.file).stem().string()];
    for (std::size_t h = span[0].get<std::size_t>() / 384; h < span[1].get<std::size_t>() / 384; ++h)
      speaks[h] = true;
    return speaks;
  }
  const double loudest = *std::max_element(powers.begin(), powers.end());
  for (std::size_t h = 0; h < powers.size(); ++h) speaks[h] = powers[h] > loudest / 1000;
  return speaks;
}

class Recordings : public ::testing::TestWithParam<Case> {};

TEST_P(Recordings, Talkers_are_followed_where_they_are) {
  const Case& c = GetParam();
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared/recordings on this machine";
  const std::filesystem::path folder = *shared / "recordings" / c.array;
  const test::Scratch out;
  const std::string config = std::string(ODAS_SOURCE_DIR) + "/tests/recordings/" + c.array + ".cfg";
  const auto run = test::run_program({test::program_path("odas"), "run", (folder / c.file).string(), "-c",
                                      config, "-o", out.folder().string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;

  const std::vector<bool> speaks = c.azimuths.empty() ? std::vector<bool>() : speech(folder, c);
  std::size_t hops = 0;
  std::size_t followed = 0;
  std::size_t tracks = 0;
  std::size_t right = 0;
  double deviation = 0;
  std::ifstream lines(out / "tracks.jsonl");
  for (std::string line; std::getline(lines, line);) {
    const auto hop = nlohmann::json::parse(line);
    const std::size_t h = hop["timeStamp"].get<std::size_t>() - 1;
    const auto& sources = hop["src"];
    if (c.azimuths.empty()) {
      tracks += sources.size();
      continue;
    }
    if (h >= speaks.size() || !speaks[h]) continue;
    ++hops;
    std::size_t right_here = 0;
    for (const auto& source : sources) {
      double least = 180;
      for (const double azimuth : c.azimuths) {
        least = std::min(least, std::abs(std::remainder(source["azimuth"].get<double>() - azimuth, 360.0)));
      }
      if (least > c.tolerance) continue;
      ++right_here;
      deviation += least;
    }
    followed += right_here > 0 ? 1 : 0;
    tracks += sources.size();
    right += right_here;
  }
  if (c.azimuths.empty()) {
    std::cout << "  " << c.name << ": " << tracks << " track-hops of nobody\n";
    EXPECT_EQ(tracks, 0U);
    return;
  }
  const double share = static_cast<double>(followed) / static_cast<double>(hops);
  const double share_right = static_cast<double>(right) / static_cast<double>(tracks);
  const double error = deviation / static_cast<double>(right);
  std::cout << "  " << c.name << ": " << hops << " hops with speech, followed within " << c.tolerance
            << " degrees in " << 100 * share << " %; of the tracks in them " << 100 * share_right
            << " % lie there, " << error << " degrees off\n";
  EXPECT_GE(share, c.followed);
  EXPECT_GE(share_right, c.right);
  EXPECT_LE(error, c.error);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, Recordings,
    ::testing::Values(
        Case{"respeaker4_hall", "respeaker4", "hall_1.5m_speech.wav", {20}, 15, 0.85, 0.98},
        Case{"respeaker4_indoor", "respeaker4", "indoor_1.5m_speech.wav", {20}, 15, 0.85, 0.98},
        Case{"respeaker4_nobody", "respeaker4", "hall_no_source.wav", {}, 0, 0, 0},
        Case{"respeaker4_air_conditioner", "respeaker4", "hall_hvac_noise.wav", {}, 0, 0, 0},
        Case{"rigid_sphere12_45", "rigid_sphere12", "aew_az045.wav", {45}, 5, 0.97, 0.97, 3},
        Case{"rigid_sphere12_315", "rigid_sphere12", "axb_az315.wav", {-45}, 5, 0.97, 0.97, 3},
        Case{"rigid_sphere12_two", "rigid_sphere12", "aew045_axb015.wav", {45, 15}, 5, 0.95, 0.93, 3},
        Case{"square4_146", "square4", "speech_-0.82918_0.55279_-0.082918.flac", {146.31}, 5, 0.95, 0.6},
        Case{"square4_180", "square4", "speech_-0.98894_0_0.14834.flac", {180}, 5, 0.95, 0.95}),
    [](const auto& recording) { return std::string(recording.param.name); });

}  // namespace
}  // namespace odas::recordings_test
