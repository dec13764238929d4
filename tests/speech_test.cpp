// SPDX-License-Identifier: MIT
// Speech or not: talkers are speech, and what hums and hisses is not, through the whole of hearing.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "support/goldens.hpp"
#include <gtest/gtest.h>
#include <sndfile.hh>

#include "odas/config/reader.hpp"
#include "odas/pipeline/pipeline.hpp"
#include "odas/scene/simulate.hpp"
#include "odas/scene/truth_file.hpp"

namespace odas::speech_test {
namespace {

namespace fs = std::filesystem;

PipelineConfig config_of(const std::string& array) {
  PipelineConfig config =
      load_configuration(fs::path(ODAS_SOURCE_DIR) / "configs" / (array + ".cfg")).config.pipeline;
  config.wanted = {.potentials = false, .tracks = false, .separated = false, .postfiltered = false};
  config.wanted.categories = true;
  return config;
}

Grid<float> read_mics(const fs::path& file) {
  SndfileHandle sound(file.string());
  std::vector<float> interleaved(static_cast<std::size_t>(sound.frames() * sound.channels()));
  sound.readf(interleaved.data(), sound.frames());
  Grid<float> mics(static_cast<std::size_t>(sound.channels()), static_cast<std::size_t>(sound.frames()));
  for (std::size_t n = 0; n < mics.cols(); ++n) {
    for (std::size_t m = 0; m < mics.rows(); ++m) mics[m][n] = interleaved[n * mics.rows() + m];
  }
  return mics;
}

/// Track-hops, and those among them that are speech.
struct Count {
  std::size_t all = 0, speech = 0;
  [[nodiscard]] double share() const { return static_cast<double>(speech) / static_cast<double>(all); }
};

template <class Counts>
Count count(const PipelineConfig& config, const Grid<float>& mics, Counts&& counts) {
  Pipeline pipeline(config);
  const std::size_t hop = pipeline.hop_size();
  Count count;
  for (std::size_t h = 0; (h + 1) * hop <= mics.cols(); ++h) {
    const HopResult result = pipeline.process_hop({mics.data() + h * hop, mics.rows(), hop, mics.cols()});
    for (const Track& track : result.tracks) {
      if (track.id == 0 || !counts(h, track)) continue;
      ++count.all;
      count.speech += track.category == Category::speech ? 1U : 0U;
    }
  }
  return count;
}

TEST(SpeechOrNot, talkers_of_the_shared_scenes_are_speech_while_they_speak) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared/scenes on this machine";
  for (const auto& [name, array] : {std::pair{"rsp4_static1", "respeaker_usb_4_mic"},
                                    {"rsp4_static2", "respeaker_usb_4_mic"},
                                    {"uma7_static2", "minidsp_uma8"},
                                    {"cma16_static2", "azimut3_closed_16"}}) {
    const PipelineConfig config = config_of(array);
    const KnownScene scene = read_truth(*shared / "scenes" / name);
    const std::size_t late = lookback_hops(config);  // the class is that of sound so old
    const Count heard =
        count(config, read_mics(*shared / "scenes" / name / "mics.wav"), [&](std::size_t h, const Track& t) {
          const std::size_t then = h < late ? 0 : h - late;
          return std::any_of(scene.sources.begin(), scene.sources.end(), [&](const KnownSource& source) {
            return source.active[then] != 0 &&
                   distance_deg(Measure::azimuth, source.direction[then],
                                {t.direction.x, t.direction.y, t.direction.z}) < 15;
          });
        });
    std::cout << "  " << name << ": of " << heard.all << " hops of tracks on talkers " << 100 * heard.share()
              << " % are speech\n";
    EXPECT_GT(heard.share(), 0.75);
  }
}

/// One source before the microphones of the ReSpeaker, for 8 s.
Grid<float> room_with(const PipelineConfig& config, std::vector<float> sound) {
  Scene scene;
  scene.seconds = 8;
  scene.rt60 = 0.25F;
  scene.noise = DiffuseNoise{NoiseColour::white, 20, {}};
  for (const MicConfig& mic : config.general.mics) scene.mics.push_back({{mic.mu[0], mic.mu[1], mic.mu[2]}});
  SceneSource source;
  source.path = {{0, 50, 25, 1.2F}};
  source.sound = std::move(sound);
  scene.sources.push_back(std::move(source));
  return simulate(scene).mics;
}

TEST(SpeechOrNot, what_hums_and_hisses_is_not_speech) {
  const PipelineConfig config = config_of("respeaker_usb_4_mic");
  std::mt19937 random(2);
  std::normal_distribution<float> normal;
  // Switched on and off, or the weights of the localizer take them for noise, and there is no track at all.
  const auto on = [](std::size_t n) { return n / 8000 % 2 == 1; };
  std::vector<float> hiss(128000);
  std::vector<float> hum(128000);
  for (std::size_t n = 0; n < hiss.size(); ++n) {
    if (!on(n)) continue;
    hiss[n] = 0.05F * normal(random);
    for (int h = 1; h <= 20; ++h)
      hum[n] +=
          static_cast<float>(0.02 * std::cos(2 * M_PI * 117 * h * static_cast<double>(n) / 16000 + h * h));
  }
  for (const auto& sound : {hiss, hum}) {
    const Count heard =
        count(config, room_with(config, sound), [](std::size_t, const Track&) { return true; });
    std::cout << "  of " << heard.all << " hops of tracks " << 100 * heard.share() << " % are speech\n";
    ASSERT_GT(heard.all, 200U);
    EXPECT_LT(heard.share(), 0.05);
  }
}

}  // namespace
}  // namespace odas::speech_test
