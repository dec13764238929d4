// SPDX-License-Identifier: MIT
#include "odas/scene/score_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::score_text_test {
namespace {

using nlohmann::json;

Score a_score() {
  Score score;
  score.seconds = 20;
  score.sources = 2;
  score.azimuth.potentials = {3.14159, 0.875};
  score.angle.potentials = {5, 0.5};
  score.azimuth.tracks.recall = 0.91234;
  score.azimuth.tracks.error_deg = 2.5;
  score.azimuth.ospa_deg = 4.25;
  score.angle.tracks.recall = 0;
  score.separated = SeparationScore{7.125, 0.25, 5, -1, 12.5, 0, 0.75, 0.5};
  return score;
}

TEST(ScoreJson, has_the_names_of_the_reference_scorer_and_three_decimals) {
  const json score = json::parse(score_json(a_score()));
  EXPECT_EQ(score.at("pot_az_err"), 3.142);
  EXPECT_EQ(score.at("pot_in15"), 0.5);
  EXPECT_EQ(score.at("az_recall"), 0.912);
  EXPECT_EQ(score.at("az_err"), 2.5);
  EXPECT_EQ(score.at("az_ospa"), 4.25);
  EXPECT_EQ(score.at("sdr"), 7.125);
  EXPECT_EQ(score.at("sir"), 12.5);
  EXPECT_EQ(score.at("stoi"), 0.75);
  EXPECT_EQ(score.at("stoi_in"), 0.5);
  EXPECT_EQ(score.at("si_sdr_in"), -1);
}

TEST(ScoreJson, says_null_for_the_error_of_no_track_and_leaves_out_what_was_not_written) {
  const json score = json::parse(score_json(a_score()));
  EXPECT_TRUE(score.at("err").is_null());
  EXPECT_FALSE(score.contains("pf_sdr"));
  Score nobody;
  EXPECT_FALSE(json::parse(score_json(nobody)).contains("recall"));
  EXPECT_TRUE(json::parse(score_json(nobody)).contains("false_s"));
}

TEST(ScoreJson, is_one_line) {
  const std::string text = score_json(a_score());
  EXPECT_EQ(text.find('\n'), text.size() - 1);
}

TEST(ScoreTable, has_a_row_a_figure_and_a_dash_where_there_is_none) {
  const std::string table = score_table(a_score());
  EXPECT_NE(table.find("20.0 s, 2 talkers\n"), std::string::npos) << table;
  EXPECT_NE(table.find("followed while talking (recall), %                91.2       0.0\n"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("error of the tracks, deg                          2.50         -\n"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("SIR, signal to other talkers            0.00     12.50         -\n"),
            std::string::npos)
      << table;
}

TEST(ScoreTable, has_no_voices_where_none_were_written) {
  Score score = a_score();
  score.separated.reset();
  EXPECT_EQ(score_table(score).find("Voices"), std::string::npos);
}

TEST(ScoreTable, keeps_every_column_at_the_right_edge_of_its_head) {
  const std::string table = score_table(a_score());
  std::size_t begin = table.find("Directions");
  while (begin < table.size()) {
    const std::size_t end = table.find('\n', begin);
    if (end > begin) { EXPECT_EQ(end - begin, 66U) << table.substr(begin, end - begin); }
    begin = end + 1;
  }
}

}  // namespace
}  // namespace odas::score_text_test
