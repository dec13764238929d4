// SPDX-License-Identifier: MIT
#include "odas/io/source_table.hpp"

#include <gtest/gtest.h>

namespace odas::source_table_test {
namespace {

TEST(SourceTable, shows_who_is_there_and_leaves_empty_slots_out) {
  std::vector<Track> tracks(3);
  tracks[2] = {
      .id = 12, .tag = "door", .direction = {0, -1, 0}, .activity = 0.5F, .category = Category::speech};
  const auto lines = source_table(tracks);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "      id   azimuth  elevation  activity         class      tag");
  EXPECT_EQ(lines[1], "      12    -90.0°       0.0°  #####      0.50  speech     door");
  EXPECT_EQ(source_table({}).at(1), "       - nobody");
}

TEST(SourceTable, a_line_for_scripts_says_the_same) {
  Track track{.id = 7, .tag = "", .direction = {0, 0, 1}, .activity = 0.25F};
  EXPECT_EQ(source_line(track), "id 7, azimuth 0.0, elevation 90.0, activity 0.25");
  track.category = Category::nonspeech;
  track.tag = "fan";
  EXPECT_EQ(source_line(track), "id 7, azimuth 0.0, elevation 90.0, activity 0.25, nonspeech, \"fan\"");
}

TEST(SourceTable, a_tag_commands_no_terminal) {
  EXPECT_EQ(harmless("caf\xC3\xA9 \x1B[2J\n\x7F"), "caf\xC3\xA9 ?[2J??");
  EXPECT_EQ(harmless("a\xC2\x9B"
                     "2Jb\xC2\xA0"),
            "a?2Jb\xC2\xA0");
}

}  // namespace
}  // namespace odas::source_table_test
