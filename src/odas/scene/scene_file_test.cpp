// SPDX-License-Identifier: MIT
#include "odas/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::scene_file_test {
namespace {

std::vector<Fault> faults_of(std::string_view text) {
  try {
    (void)read_scene_text(text, ".", "test.json");
  } catch (const ConfigError& error) { return error.faults(); }
  return {};
}

bool says(const std::vector<Fault>& faults, std::string_view path, std::string_view what) {
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
    return fault.path == path && fault.what.find(what) != std::string::npos && fault.file == "test.json";
  });
}

TEST(SceneFile, Reads_a_whole_scene) {
  const Scene scene = read_scene_text(R"({
    "seconds": 1.5, "sample_rate": 8000, "hop": 64, "seed": 9, "speed_of_sound": 340,
    "array": { "pattern": "cardioid", "mics": [ { "position": [0.1, 0, 0], "direction": [2, 0, 0] },
                                                { "position": [-0.1, 0, 0], "pattern": "omni" } ] },
    "room": { "size": [5, 4, 3], "rt60": 0.2, "array_position": [2, 2, 1] },
    "sources": [ { "name": "hum", "noise": "fan", "target": true, "start": 0.5,
                   "path": [ { "azimuth": 10 }, { "time": 1, "azimuth": 20, "elevation": 5, "distance": 1 } ] },
                 { "noise": "white", "path": [ { "azimuth": 90 } ] } ],
    "noise": { "kind": "pink", "snr_db": 7 } })",
                                      ".", "test.json");
  EXPECT_EQ(scene.samples(), 12000U);
  EXPECT_EQ(scene.hops(), 187U);
  EXPECT_EQ(scene.seed, 9U);
  EXPECT_EQ(scene.speed_of_sound, 340);
  ASSERT_EQ(scene.mics.size(), 2U);
  EXPECT_EQ(scene.mics[0].omni, 0.5F);
  EXPECT_EQ(scene.mics[0].axis, (Vec3{1, 0, 0}));
  EXPECT_EQ(scene.mics[1].omni, 1);
  EXPECT_EQ(scene.array_position, (Vec3{2, 2, 1}));
  ASSERT_EQ(scene.sources.size(), 2U);
  EXPECT_TRUE(scene.sources[0].is_target);
  EXPECT_FALSE(scene.sources[1].is_target);
  ASSERT_EQ(scene.sources[0].path.size(), 2U);
  EXPECT_EQ(scene.sources[0].path[1].elevation, 5);
  EXPECT_EQ(scene.sources[0].sound[3999], 0);
  EXPECT_NE(scene.sources[0].sound[4100], 0);
  EXPECT_EQ(scene.noise->colour, NoiseColour::pink);
  EXPECT_EQ(scene.noise->snr_db, 7);
}

TEST(SceneFile, Says_all_faults_at_once_with_their_paths) {
  const auto faults = faults_of(R"({
    "seconds": -1, "colour": "red", "array": { "mics": [ { "position": [0, 0] }, { "position": [0, 0, 0],
    "direction": [0, 0, 0] } ] },
    "room": { "rt60": 99 },
    "sources": [ { "path": [ { "azimuth": 1 } ] },
                 { "noise": "blue", "path": [] },
                 { "noise": "fan", "say": "a", "path": [ { "time": 2, "azimuth": 0 }, { "time": 1, "azimuth": 0,
                   "distance": -1 } ] } ] })");
  EXPECT_TRUE(says(faults, "seconds", "at least") || says(faults, "seconds", "from 0.1"));
  EXPECT_TRUE(says(faults, "colour", "not a key"));
  EXPECT_TRUE(says(faults, "array.mics[0].position", "three numbers"));
  EXPECT_TRUE(says(faults, "array.mics[1].direction", "zero"));
  EXPECT_TRUE(says(faults, "room.size", "missing"));
  EXPECT_TRUE(says(faults, "room.rt60", "from 0 to 5"));
  EXPECT_TRUE(says(faults, "sources[0]", "exactly one of"));
  EXPECT_TRUE(says(faults, "sources[1].noise", "one of white, pink, fan"));
  EXPECT_TRUE(says(faults, "sources[1].path", "at least one waypoint"));
  EXPECT_TRUE(says(faults, "sources[2]", "exactly one of"));
  EXPECT_TRUE(says(faults, "sources[2].path[1].time", "after"));
  EXPECT_TRUE(says(faults, "sources[2].path[1].distance", "from 0.1"));
}

TEST(SceneFile, A_talker_who_walks_through_a_wall_is_told_when) {
  const auto faults = faults_of(R"({
    "seconds": 4, "array": { "mics": [ { "position": [0, 0, 0] } ] },
    "room": { "size": [4, 4, 3], "rt60": 0.2, "array_position": [2, 2, 1] },
    "sources": [ { "noise": "fan", "path": [ { "time": 0, "azimuth": 0, "distance": 1 },
                                             { "time": 4, "azimuth": 0, "distance": 3 } ] } ] })");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_TRUE(says(faults, "sources[0].path", "outside of the room at 2"));
}

TEST(SceneFile, A_broken_array_file_is_a_fault_of_the_scene) {
  const auto faults = faults_of(R"({ "seconds": 1, "array": "no_such.cfg" })");
  EXPECT_TRUE(says(faults, "array", "no_such.cfg"));
  EXPECT_TRUE(says(faults_of(R"({ "seconds": 1 })"), "array", "missing"));
}

TEST(SceneFile, What_is_no_JSON_is_said_with_its_place) {
  EXPECT_TRUE(says(faults_of("{ \"seconds\": 1,, }"), "", "line 1"));
  EXPECT_TRUE(says(faults_of("[1, 2]"), "", "object"));
}

TEST(SceneFile, Missing_files_are_the_worlds_fault) {
  EXPECT_THROW((void)read_scene("no_such_scene.json"), IoError);
  EXPECT_THROW((void)read_scene_text(R"({ "seconds": 1, "array": { "mics": [ { "position": [0, 0, 0] } ] },
    "sources": [ { "speech": "no_such.wav", "path": [ { "azimuth": 0 } ] } ] })",
                                     ".", "test.json"),
               IoError);
}

}  // namespace
}  // namespace odas::scene_file_test
