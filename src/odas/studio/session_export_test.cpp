// SPDX-License-Identifier: MIT
#include "odas/studio/session_export.hpp"

#include <sstream>

#include "support/hop_maker.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/studio/session_recorder.hpp"

namespace odas::session_export_test {
namespace {

using nlohmann::json;

/// Voice 1 in hops 1 to 100 and 120 to 200, voice 2 in hops 50 to 250.
std::string make_session(const test::Scratch& scratch) {
  test::HopMaker hops;
  SessionRecorder session(scratch.folder(), {});
  hops.time = 1000;
  EXPECT_TRUE(session.begin(hops.info(), 1000).ok());
  for (int i = 1; i <= 250; ++i) {
    const bool first = i <= 100 || (i >= 120 && i <= 200);
    hops.category = Category::speech;
    EXPECT_TRUE(session.hop(hops.next({first ? 1U : 0U, i >= 50 ? 2U : 0U})).ok());
  }
  EXPECT_TRUE(session.close().ok());
  return session.name();
}

std::string exported(ExportFormat format) {
  const test::Scratch scratch;
  std::ostringstream out;
  EXPECT_EQ(export_session(SessionReader(scratch / make_session(scratch)), format, "my session", out), "");
  return out.str();
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SessionExport, rttm_has_a_line_for_each_span_of_talk) {
  EXPECT_EQ(exported(ExportFormat::rttm),
            "SPEAKER my_session 1 0.000 1.600 <NA> <NA> source_1 <NA> <NA>\n"
            "SPEAKER my_session 1 0.392 1.608 <NA> <NA> source_2 <NA> <NA>\n")
      << "a pause of 152 ms is within the talk";
}

TEST(SessionExport, csv_has_a_row_for_each_track_and_hop) {
  const std::string csv = exported(ExportFormat::csv);
  EXPECT_EQ(lines(csv), 1U + 181 + 201);
  EXPECT_TRUE(csv.starts_with(
      "timeStamp,time,utc,slot,id,tag,x,y,z,azimuth,elevation,activity,level,class\n"
      "1001,0.000,2026-01-31T12:00:08.000Z,0,1,dynamic,0.0000,1.0000,0.0000,90.00,0.00,1.000,-9.0,speech\n"))
      << csv.substr(0, 300);
}

TEST(SessionExport, jsonl_is_that_of_the_outputs) {
  std::istringstream text(exported(ExportFormat::jsonl));
  std::string line;
  ASSERT_TRUE(std::getline(text, line));
  const json first = json::parse(line);
  EXPECT_EQ(first["timeStamp"], 1001);
  EXPECT_EQ(first["src"][0]["azimuth"], 90.0);
  EXPECT_EQ(first["src"][0]["class"], "speech");
  std::size_t count = 1;
  while (std::getline(text, line)) count += json::parse(line).contains("src") ? 1 : 0;
  EXPECT_EQ(count, 250U);
}

TEST(SessionExport, of_a_session_that_was_cut_has_what_there_is) {
  const test::Scratch scratch;
  const std::string whole = test::content(scratch / make_session(scratch));
  test::write_file(scratch / "cut.mcap", whole.substr(0, whole.size() / 3));
  std::ostringstream out;
  EXPECT_TRUE(export_session(SessionReader(scratch / "cut.mcap"), ExportFormat::csv, "", out)
                  .starts_with("was cut off after "));
  EXPECT_GT(lines(out.str()), 50U);
}

TEST(SessionExport, knows_its_formats) {
  EXPECT_EQ(export_format("rttm"), ExportFormat::rttm);
  EXPECT_FALSE(export_format("xls").has_value());
}

}  // namespace
}  // namespace odas::session_export_test
