// SPDX-License-Identifier: MIT
#include "odas/scene/listening.hpp"

#include <gtest/gtest.h>

namespace odas::listening_test {
namespace {

TEST(Listening, Hears_every_hop_of_the_scene_from_its_first_on) {
  Scene scene;
  scene.seconds = 0.4;
  Configuration config;
  for (const float x : {-0.03F, 0.03F}) {
    MicConfig mic;
    mic.mu = {x, 0, 0};
    config.pipeline.general.mics.push_back(mic);
    scene.mics.push_back({{x, 0, 0}, {0, 0, 1}, 1, 1});
  }
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

}  // namespace
}  // namespace odas::listening_test
