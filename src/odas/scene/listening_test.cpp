// SPDX-License-Identifier: MIT
#include "odas/scene/listening.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "odas/scene/noise.hpp"

namespace odas::listening_test {
namespace {

/// 6 cm apart, in the scene and in the configuration that listens to it.
void put_two_microphones(Scene& scene, Configuration& config) {
  for (const float x : {-0.03F, 0.03F}) {
    MicConfig mic;
    mic.mu = {x, 0, 0};
    config.pipeline.general.mics.push_back(mic);
    scene.mics.push_back({{x, 0, 0}, {0, 0, 1}, 1, 1});
  }
}

TEST(Listening, Hears_every_hop_of_the_scene_from_its_first_on) {
  Scene scene;
  scene.seconds = 0.4;
  Configuration config;
  put_two_microphones(scene, config);
  config.pipeline.wanted = {true, true, false, false};
  SimulatedScene simulated;
  simulated.mics = Grid<float>(2, scene.samples());
  simulated.mics[0][100] = 0.123456F;
  const PlayedScene scene_played = played(scene, std::move(simulated));
  EXPECT_EQ(scene_played.mics[0][100], 4045 / 32768.F);  // as a file of 16 bit has it
  const Audition heard = listen(scene_played, config);
  ASSERT_EQ(heard.tracks.size(), scene.hops());
  EXPECT_EQ(heard.tracks.front().hop, 0U);
  EXPECT_FALSE(heard.separated);
}

TEST(Listening, Gives_each_voice_for_the_hop_that_it_is_of_however_late_it_comes) {
  Scene scene;
  scene.seconds = 1;
  Configuration config;
  put_two_microphones(scene, config);
  config.pipeline.sst.target = {{"above", 0, 0, 1}};
  config.pipeline.sss.lookback = 100;
  config.pipeline.sss.frame_size = 512;
  config.pipeline.wanted = {true, true, true, false};
  const auto sound = point_noise(NoiseColour::pink, scene.samples(), scene.sample_rate, 1);
  SimulatedScene simulated;
  simulated.mics = Grid<float>(2, scene.samples());
  for (std::size_t m = 0; m < 2; ++m) std::ranges::copy(sound, simulated.mics[m].begin());
  const PlayedScene scene_played = played(scene, std::move(simulated));
  const Audition heard = listen(scene_played, config);
  ASSERT_TRUE(heard.separated);
  std::vector<float> voice(scene.hop);
  for (const std::size_t hop : {20UL, scene.hops() - 1}) {  // the last one, too
    ASSERT_EQ(heard.tracks[hop].tracks.size(), 1U);
    heard.separated(hop, heard.tracks[hop].tracks[0], voice);
    for (std::size_t n = 0; n < scene.hop; ++n) {
      ASSERT_NEAR(voice[n], scene_played.sound.mic[hop * scene.hop + n], 1e-4) << hop << ' ' << n;
    }
    HeardTrack somebody_else = heard.tracks[hop].tracks[0];
    ++somebody_else.id;
    heard.separated(hop, somebody_else, voice);
    EXPECT_EQ(voice, std::vector<float>(scene.hop, 0.F));
  }
}

}  // namespace
}  // namespace odas::listening_test
