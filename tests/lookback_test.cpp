// SPDX-License-Identifier: MIT
// The first syllable: the audio of a voice begins where its first word does, although the track is found
// later.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include "support/goldens.hpp"
#include "support/read_sound.hpp"
#include <gtest/gtest.h>

#include "odas/config/reader.hpp"
#include "odas/pipeline/pipeline.hpp"
#include "odas/scene/simulate.hpp"
#include "odas/scene/truth_file.hpp"

namespace odas::lookback_test {
namespace {

namespace fs = std::filesystem;

constexpr double kPause = 0.3;      // s: a longer one parts two utterances
constexpr double kTolerance = 15;   // degrees of azimuth: so near a track is that of the talker
constexpr double kMayMiss = 0.020;  // s
constexpr double kNever = 1e9;      // s

/// Our own file for an array, with or without its look-back.
PipelineConfig array_config(const std::string& name, bool look_back = true) {
  PipelineConfig config =
      load_configuration(fs::path(ODAS_SOURCE_DIR) / "configs" / (name + ".cfg")).config.pipeline;
  config.wanted = {.potentials = false, .tracks = true, .separated = true, .postfiltered = false};
  if (!look_back) config.sss.lookback = 0;
  return config;
}

/// What was heard of one source.
struct Voice {
  double begins = 0;                       // s of the recording: where the first sample of its audio lies
  std::vector<std::optional<Vec3>> place;  // [hop]
};

std::vector<Voice> hear(const PipelineConfig& config, const Grid<float>& mics) {
  Pipeline pipeline(config);
  const std::size_t hop = pipeline.hop_size();
  const double hop_s = static_cast<double>(hop) / pipeline.sample_rate();
  const std::size_t hops = mics.cols() / hop;
  std::vector<Voice> voices;
  for (std::size_t h = 0; h < hops; ++h) {
    const HopResult result = pipeline.process_hop({mics.data() + h * hop, mics.rows(), hop, mics.cols()});
    for (const Track& track : result.tracks) {
      if (track.id == 0) continue;
      if (track.id > voices.size()) {  // ids rise by one
        const double begins = static_cast<double>(h) * hop_s - voice_delay_s(config);
        voices.push_back({begins, std::vector<std::optional<Vec3>>(hops)});
      }
      voices[track.id - 1].place[h] = track.direction;
    }
  }
  return voices;
}

/// What is missing at the beginning of each utterance that is tracked, s.
std::vector<double> missing(const KnownScene& scene, const std::vector<Voice>& voices) {
  std::vector<double> all;
  const auto pause = static_cast<std::size_t>(kPause / scene.hop_seconds());
  for (const KnownSource& source : scene.sources) {
    std::size_t silent = pause;
    double begins = 0;
    double least = kNever;
    const auto close = [&] {
      if (least < kNever) all.push_back(least);
      least = kNever;
    };
    for (std::size_t h = 0; h < scene.hops; ++h) {
      if (source.active[h] == 0) {
        ++silent;
        continue;
      }
      if (silent >= pause) {
        close();
        begins = static_cast<double>(h) * scene.hop_seconds();
      }
      silent = 0;
      for (const Voice& voice : voices) {
        if (h >= voice.place.size() || !voice.place[h]) continue;
        const Vec3& u = *voice.place[h];
        if (distance_deg(Measure::azimuth, source.direction[h], {u.x, u.y, u.z}) > kTolerance) continue;
        const double lost = std::max(0.0, voice.begins - begins);
        least = std::min(least, lost);
      }
    }
    close();
  }
  return all;
}

double share_whole(const std::vector<double>& missing) {
  const auto whole = std::count_if(missing.begin(), missing.end(), [](double s) { return s <= kMayMiss; });
  return static_cast<double>(whole) / static_cast<double>(missing.size());
}

struct Case {
  const char* scene;
  const char* array;
};

TEST(FirstSyllable, is_there_in_the_shared_scenes_in_19_of_20_utterances_that_are_tracked) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared/scenes on this machine";
  std::vector<double> with;
  std::vector<double> without;
  for (const Case& c :
       {Case{"rsp4_static1", "respeaker_usb_4_mic"}, Case{"rsp4_static2", "respeaker_usb_4_mic"},
        Case{"rsp4_moving1", "respeaker_usb_4_mic"}, Case{"rsp4_cross2", "respeaker_usb_4_mic"},
        Case{"rsp4_noisy1", "respeaker_usb_4_mic"}, Case{"uma7_static2", "minidsp_uma8"},
        Case{"uma7_static4", "minidsp_uma8"}, Case{"oma16_static2", "azimut3_open_16"},
        Case{"cma16_static2", "azimut3_closed_16"}}) {
    const fs::path folder = *shared / "scenes" / c.scene;
    const KnownScene scene = read_truth(folder);
    const Grid<float> mics = test::read_sound(folder / "mics.wav");
    for (const bool look_back : {true, false}) {
      std::vector<double>& all = look_back ? with : without;
      const auto lost = missing(scene, hear(array_config(c.array, look_back), mics));
      all.insert(all.end(), lost.begin(), lost.end());
    }
  }
  std::cout << "  of " << with.size() << " utterances that are tracked at most 20 ms are missing in "
            << 100 * share_whole(with) << " %; without look-back in " << 100 * share_whole(without) << " %\n";
  EXPECT_GE(with.size(), 50U);
  EXPECT_GE(share_whole(with), 0.95);
  EXPECT_LT(share_whole(without), 0.8) << "or there is nothing to mend";
}

/// Two who speak in turns, and then at once, before the microphones of the ReSpeaker.
Scene dialogue(const PipelineConfig& config) {
  Scene scene;
  scene.seconds = 8;
  scene.rt60 = 0.2F;
  scene.noise = DiffuseNoise{NoiseColour::white, 25, {}};
  for (const MicConfig& mic : config.general.mics) scene.mics.push_back({{mic.mu[0], mic.mu[1], mic.mu[2]}});
  struct Talker {
    float azimuth;
    double pitch;
    std::vector<double> words;  // s: when an utterance of 1.2 s begins
  };
  for (const Talker& talker : {Talker{-40, 130, {0.5, 3.5, 6}}, Talker{100, 210, {2.1, 6}}}) {
    SceneSource source;
    source.path = {{0, talker.azimuth, 25, 1.2F}};
    source.sound.resize(scene.samples());
    double phase = 0;
    for (std::size_t n = 0; n < source.sound.size(); ++n) {
      const double t = static_cast<double>(n) / scene.sample_rate;
      phase += 2 * M_PI * talker.pitch * (1 + 0.2 * std::sin(2 * M_PI * 1.3 * t)) / scene.sample_rate;
      for (const double begins : talker.words) {
        const double in = t - begins;
        if (in < 0 || in > 1.2) continue;
        const double syllables = 0.55 - 0.45 * std::cos(2 * M_PI * 4 * in);
        for (int h = 1; h <= 25; ++h) {
          source.sound[n] += static_cast<float>(0.03 * syllables * std::cos(h * phase + h * h));
        }
      }
    }
    scene.sources.push_back(std::move(source));
  }
  return scene;
}

TEST(FirstSyllable, is_there_in_a_dialogue_of_our_own) {
  const PipelineConfig config = array_config("respeaker_usb_4_mic");
  const Scene scene = dialogue(config);
  const SimulatedScene played = simulate(scene);
  KnownScene known;
  known.hops = scene.hops();
  for (const SourceTruth& truth : played.truth) {
    KnownSource& source = known.sources.emplace_back();
    source.active = truth.active;
    for (const Vec3& u : truth.direction) source.direction.push_back({u.x, u.y, u.z});
  }
  const auto lost = missing(known, hear(config, played.mics));
  EXPECT_GE(lost.size(), 4U);
  EXPECT_EQ(share_whole(lost), 1);
  const auto without = missing(known, hear(array_config("respeaker_usb_4_mic", false), played.mics));
  EXPECT_GT(*std::max_element(without.begin(), without.end()), *std::max_element(lost.begin(), lost.end()))
      << "or there is nothing to mend";
}

}  // namespace
}  // namespace odas::lookback_test
