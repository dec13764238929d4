// SPDX-License-Identifier: MIT
#include "odas/scene/audition.hpp"

#include <fstream>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::audition_test {
namespace {

namespace fs = std::filesystem;

class AuditionFiles : public ::testing::Test {
 protected:
  void write(const char* name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] Audition read() const { return read_audition(folder_, {}); }

  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

constexpr std::string_view kOdasTracks = R"({
    "timeStamp": 1,
    "src": [
        { "id": 0, "tag": "", "x": 0.000, "y": 0.000, "z": 0.000, "activity": 0.000 },
        { "id": 5, "tag": "dynamic", "x": 0.600, "y": -0.800, "z": 0.000, "activity": 1.000 }
    ]
}
{
    "timeStamp": 2,
    "src": [
        { "id": 0, "tag": "", "x": 0.000, "y": 0.000, "z": 0.000, "activity": 0.000 },
        { "id": 0, "tag": "", "x": 0.000, "y": 0.000, "z": 0.000, "activity": 0.000 }
    ]
}
)";

TEST_F(AuditionFiles, of_odas_hold_a_track_for_every_slot_that_has_an_id) {
  write("tracks.json", kOdasTracks);
  const Audition audition = read();
  ASSERT_EQ(audition.tracks.size(), 2U);
  EXPECT_EQ(audition.tracks[0].hop, 0U);
  ASSERT_EQ(audition.tracks[0].tracks.size(), 1U);
  EXPECT_EQ(audition.tracks[0].tracks[0].slot, 1U);
  EXPECT_EQ(audition.tracks[0].tracks[0].id, 5U);
  EXPECT_DOUBLE_EQ(audition.tracks[0].tracks[0].direction.y, -0.8);
  EXPECT_TRUE(audition.tracks[1].tracks.empty());
  EXPECT_FALSE(audition.potentials.has_value());
  EXPECT_FALSE(audition.separated);
}

TEST_F(AuditionFiles, of_json_lines_say_the_slot_themselves) {
  write("tracks.jsonl",
        "{\"timeStamp\":7,\"time\":0.048,\"src\":[{\"slot\":3,\"id\":2,\"x\":1,\"y\":0,\"z\":0}]}\n");
  const Audition audition = read();
  ASSERT_EQ(audition.tracks.size(), 1U);
  EXPECT_EQ(audition.tracks[0].hop, 6U);
  EXPECT_EQ(audition.tracks[0].tracks[0].slot, 3U);
}

TEST_F(AuditionFiles, count_as_far_as_they_go_when_cut) {
  write("tracks.json", kOdasTracks.substr(0, kOdasTracks.size() - 40));
  EXPECT_EQ(read().tracks.size(), 1U);
}

TEST_F(AuditionFiles, may_have_zero_bytes_between_the_objects) {
  std::string text(kOdasTracks);
  text.insert(text.find("}\n{") + 1, std::string(3, '\0'));
  write("tracks.json", text);
  EXPECT_EQ(read().tracks.size(), 2U);
}

TEST_F(AuditionFiles, give_the_strongest_potential_of_a_hop) {
  write("tracks.json", "");
  write("potentials.jsonl",
        R"({"timeStamp":3,"src":[{"x":1,"y":0,"z":0,"E":0.1},{"x":0,"y":1,"z":0,"E":0.3},)"
        R"({"x":0,"y":0,"z":1,"E":0.2}]}{"timeStamp":4,"src":[]})");
  const Audition audition = read();
  ASSERT_EQ(audition.potentials->size(), 1U);
  EXPECT_EQ(audition.potentials->at(0).hop, 2U);
  EXPECT_EQ(audition.potentials->at(0).direction.y, 1);
}

TEST_F(AuditionFiles, have_voices_where_raw_sound_is_beside_them) {
  write("tracks.json", kOdasTracks);
  write("separated.raw", std::string(2 * 2 * 128 * 2, '\1'));
  write("postfiltered.raw", "");
  const Audition audition = read();
  ASSERT_TRUE(audition.separated);
  std::vector<float> out(128);
  audition.separated(1, {1, 5, {}}, out);
  EXPECT_EQ(out[127], 257.F / 32768);
  EXPECT_FALSE(audition.postfiltered);
}

TEST_F(AuditionFiles, say_what_is_missing_or_is_something_else) {
  EXPECT_THROW(static_cast<void>(read()), IoError);
  write("tracks.json", R"({"timeStamp":1,"src":[{"id":1,"x":"north"}]})");
  try {
    static_cast<void>(read());
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("tracks.json is not a system's output"), std::string::npos);
  }
}

}  // namespace
}  // namespace odas::audition_test
