// SPDX-License-Identifier: MIT
#include "odas/scene/bench_scene.hpp"

#include <algorithm>
#include <cmath>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"
#include "odas/scene/bench_run.hpp"
#include "odas/scene/sound.hpp"
#include "odas/scene/trajectory.hpp"

namespace odas::bench_scene_test {
namespace {

GeneralConfig square() {
  GeneralConfig array;
  for (const auto& [x, y] : {std::pair{-0.032F, 0.F}, {0.F, -0.032F}, {0.032F, 0.F}, {0.F, 0.032F}}) {
    MicConfig mic;
    mic.mu = {x, y, 0};
    array.mics.push_back(mic);
  }
  return array;
}

/// As a camera has it under its lens: it tells no height, and listens ahead alone.
GeneralConfig line() {
  GeneralConfig array;
  for (const float y : {-0.03F, -0.01F, 0.01F, 0.03F}) {
    MicConfig mic;
    mic.mu = {0, y, 0};
    array.mics.push_back(mic);
  }
  array.spatialfilters = {{{1, 0, 0}, {90, 95}}, {{0, 0, 1}, {90, 95}}, {{0, 0, -1}, {90, 95}}};
  return array;
}

BenchScene small(BenchMotion motion = BenchMotion::still) {
  BenchScene bench;
  bench.group = "small";
  bench.array = "square";
  bench.mics = 4;
  bench.talkers = 2;
  bench.motion = motion;
  bench.seconds = 2;
  bench.rt60 = 0.2F;
  return bench;
}

/// Talkers are spoken by espeak-ng.
class BenchSceneTest : public testing::Test {
 protected:
  void SetUp() override {
    SoundRecipe word;
    word.kind = SoundRecipe::Kind::speech;
    word.utterances.push_back({0, "a"});
    try {
      static_cast<void>(make_sound(word, 16000, 1600, 0));
    } catch (const IoError& error) { GTEST_SKIP() << error.what(); }
  }
};

TEST_F(BenchSceneTest, Talkers_stand_apart_in_the_room_and_above_a_flat_array) {
  for (std::uint32_t seed = 1; seed < 4; ++seed) {
    BenchScene bench = small();
    bench.seed = seed;
    bench.talkers = 3;
    bench.distance = 3;
    const Scene scene = make_scene(bench, square());
    ASSERT_EQ(scene.sources.size(), 3U);
    for (std::size_t a = 0; a < 3; ++a) {
      const Vec3 place = scene.array_position + position_at(scene.sources[a].path, 0);
      EXPECT_GT(std::min({place.x, place.y, place.z}), 0);
      EXPECT_GT(std::min({scene.room.x - place.x, scene.room.y - place.y, scene.room.z - place.z}), 0);
      EXPECT_GE(scene.sources[a].path[0].elevation, 0);
      for (std::size_t b = 0; b < a; ++b) {
        const float apart = scene.sources[a].path[0].azimuth - scene.sources[b].path[0].azimuth;
        EXPECT_GE(std::abs(std::remainder(apart, 360.F)), 35);
      }
    }
  }
}

TEST_F(BenchSceneTest, Who_talks_to_a_line_that_listens_ahead_is_ahead) {
  for (std::uint32_t seed = 1; seed < 4; ++seed) {
    BenchScene bench = small(BenchMotion::crossing);
    bench.seed = seed;
    for (const SceneSource& source : make_scene(bench, line()).sources) {
      for (const Waypoint& point : source.path) EXPECT_LE(std::abs(point.azimuth), 75) << seed;
    }
  }
}

TEST_F(BenchSceneTest, Who_crosses_ends_where_the_other_began) {
  const Scene scene = make_scene(small(BenchMotion::crossing), square());
  const auto azimuth = [&](std::size_t talker, double time) {
    return waypoint_at(scene.sources[talker].path, time).azimuth;
  };
  EXPECT_NEAR(std::remainder(azimuth(0, 2) - azimuth(1, 0), 360.F), 0, 1e-3);
  EXPECT_NEAR(std::remainder(azimuth(1, 2) - azimuth(0, 0), 360.F), 0, 1e-3);
}

TEST_F(BenchSceneTest, Inexact_microphones_are_about_2_mm_off_and_the_listener_is_not_told) {
  BenchScene bench = small();
  bench.inexact = true;
  bench.talkers = 0;
  double square_error = 0;
  constexpr int kSeeds = 20;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    bench.seed = seed;
    const Scene scene = make_scene(bench, square());
    for (std::size_t m = 0; m < 4; ++m) {
      const std::array<float, 3> mu = square().mics[m].mu;
      square_error +=
          std::pow(static_cast<double>(norm(scene.mics[m].position - Vec3{mu[0], mu[1], mu[2]})), 2);
      EXPECT_LE(std::abs(20 * std::log10(scene.mics[m].gain)), 3.001F);
    }
  }
  EXPECT_NEAR(std::sqrt(square_error / (4 * kSeeds)), 0.002, 0.0003);
}

TEST_F(BenchSceneTest, A_scene_that_was_kept_is_bit_for_bit_the_one_that_was_played) {
  const test::Scratch scratch;
  const BenchSound fresh = bench_sound(small(), square(), {});
  const BenchSound first = bench_sound(small(), square(), scratch.folder());
  const BenchSound second = bench_sound(small(), square(), scratch.folder());
  for (const BenchSound* other : {&first, &second}) {
    ASSERT_EQ(other->played.mics.cols(), fresh.played.mics.cols());
    EXPECT_TRUE(std::equal(fresh.played.mics.data(), fresh.played.mics.data() + 4 * fresh.played.mics.cols(),
                           other->played.mics.data()));
    EXPECT_EQ(other->played.sound.images, fresh.played.sound.images);
    EXPECT_EQ(other->tdoa_bounds, fresh.tdoa_bounds);
    ASSERT_EQ(other->played.truth.sources.size(), 2U);
    EXPECT_EQ(other->played.truth.sources[1].active, fresh.played.truth.sources[1].active);
    EXPECT_EQ(other->played.truth.sources[1].direction[9].x, fresh.played.truth.sources[1].direction[9].x);
  }
}

}  // namespace
}  // namespace odas::bench_scene_test
